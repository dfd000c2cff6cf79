// Stands in for Flamenco Manager: compiles a job by a job type and prints its tasks as JSON.
//
//     node flamenco_stand_in.js JOB_TYPE.js SETTINGS.json
//
// Written from the interface that https://flamenco.blender.org/usage/job-types/ and the scripts built into
// Flamenco 3 show: author.Task, author.Command, job.addTask, path, frameChunker, print.

const fs = require("fs");
const posix = require("path").posix;
const vm = require("vm");

function Task(name, type) {
    if (!name || !type)
        throw new Error("author.Task(name, type): both are required");
    const task = { name: name, type: type, commands: [], dependencies: [] };
    // Flamenco copies a task when it is added to the job; what is added later is lost.
    Object.defineProperty(task, "addCommand", { value: (command) => task.commands.push(command) });
    Object.defineProperty(task, "addDependency", {
        value: (other) => task.dependencies.push(other.name) });
    return task;
}

function frameChunker(range, size) {
    const frames = new Set();
    for (const part of range.replaceAll("..", "-").split(",")) {
        const ends = part.split("-").map((text) => Number.parseInt(text.trim(), 10));
        if (ends.length > 2 || ends.some(Number.isNaN))
            throw new Error(`invalid range "${range}"`);
        for (let frame = ends[0]; frame <= ends[ends.length - 1]; frame++)
            frames.add(frame);
    }
    const all = [...frames].sort((a, b) => a - b);
    if (size != 1)
        throw new Error("the stand-in chunks by single frames alone");
    return all.map(String);
}

const [script, settings] = process.argv.slice(2);
const tasks = [];
const context = vm.createContext({
    author: {
        Task: Task,
        Command: (name, parameters) => ({ name: name, parameters: parameters }),
    },
    path: {
        basename: posix.basename, dirname: posix.dirname, join: posix.join,
        stem: (file) => posix.parse(file).name,
    },
    frameChunker: frameChunker,
    print: () => {},
});
vm.runInContext(fs.readFileSync(script, "utf8"), context, { filename: script });
context.job = {
    name: "job", settings: JSON.parse(fs.readFileSync(settings, "utf8")),
    addTask: (task) => tasks.push(JSON.parse(JSON.stringify(task))),
};
try {
    vm.runInContext("compileJob(job)", context);
} catch (problem) {
    console.error(String(problem));
    process.exit(1);
}
console.log(JSON.stringify({ type: vm.runInContext("JOB_TYPE", context), tasks: tasks }));
