// Job type of Flamenco 3: renders frames by hipmap in tasks of tiles and passes, and puts them together.
// Installed by copying it into the folder "scripts" beside flamenco-manager (docs/many_machines.md).
// The manager's variables hipmapRender and hipmapPreprocess name the programs on the workers.

const JOB_TYPE = {
    label: "hipmap",
    description: "Render a scene that was exported for hipmap (.glb)",
    settings: [
        { key: "scene", type: "string", subtype: "file_path", required: true,
          eval: "str(abspath(bpy.data.filepath).with_suffix('.glb'))",
          description: "Scene to render, exported as .glb" },
        { key: "frames", type: "string", required: true,
          eval: "f'{C.scene.frame_start}-{C.scene.frame_end}'",
          description: "Frames to render, such as '47', '1-30' or '3, 5-10'" },
        { key: "fps", type: "float", eval: "C.scene.render.fps / C.scene.render.fps_base", default: 24,
          visible: "hidden", description: "Frames a second of the animation" },
        { key: "passes", type: "int32", default: 64, propargs: { min: 1 },
          description: "Passes of each frame" },
        { key: "chunk_size", type: "int32", default: 16, propargs: { min: 1 },
          description: "Passes in a task" },
        { key: "tiles", type: "string", default: "1x1",
          description: "Grid of tiles that each frame is divided into, such as '2x2'" },
        { key: "size", type: "string", required: true,
          eval: "'{}x{}'.format(C.scene.render.resolution_x * C.scene.render.resolution_percentage // 100, "
              + "C.scene.render.resolution_y * C.scene.render.resolution_percentage // 100)",
          description: "Size of the image in pixels" },
        { key: "options", type: "string", default: "",
          description: "More options of hipmap's render, separated by spaces" },
        { key: "output", type: "string", subtype: "dir_path", required: true,
          description: "Folder for images, previews and states, which all workers see" },
        { key: "preview_video", type: "bool", default: true,
          description: "Make a video of the frames" },
    ]
};

function compileJob(job) {
    const plan = planOf(job.settings);
    const merges = [];
    for (const frame of plan.frames) {
        const merge = addFrame(job, plan, frame);
        merges.push(merge);
    }
    if (plan.video && merges.length > 1)
        addVideo(job, plan, merges);
}

// What all tasks know.  Throws a line on settings that make no sense.
function planOf(settings) {
    const grid = /^([1-9][0-9]*)x([1-9][0-9]*)$/.exec(`${settings.tiles}`.trim());
    if (!grid)
        throw `tiles: '${settings.tiles}' is no grid; write COLUMNSxROWS, such as 2x2`;
    const passes = Number(settings.passes);
    const chunk = Number(settings.chunk_size);
    if (!(passes >= 1) || !(chunk >= 1))
        throw "passes, chunk_size: give whole numbers from 1";
    if (!settings.scene || !settings.output)
        throw "scene, output: name the exported scene and a folder";
    const folder = settings.output;
    return {
        scene: settings.scene,
        folder: folder,
        partition: path.join(folder, `${path.stem(settings.scene)}.hpm`),
        frames: frameChunker(settings.frames, 1),
        fps: settings.fps || 24,
        passes: passes,
        chunk: chunk,
        grid: grid[0],
        tiles: Number(grid[1]) * Number(grid[2]),
        options: ["--size", settings.size].concat(`${settings.options || ""}`.split(/\s+/).filter(Boolean)),
        video: settings.preview_video,
    };
}

function exec(exe, args) {
    return author.Command("exec", { exe: exe, args: args.map(String) });
}

// "image.png" of frame 7 becomes "image.0007.png", as hipmap names files of frames.
function ofFrame(frame, name, suffix) {
    return `${name}.${`${frame}`.padStart(4, "0")}${suffix}`;
}

function animation(plan, frame) {
    return ["--frames", frame, "--fps", plan.fps];
}

// Adds the tasks of a frame; returns that which has its image.
function addFrame(job, plan, frame) {
    const states = path.join(plan.folder, "states", `${frame}`);
    const prepare = author.Task(`preprocess-${frame}`, "misc");
    prepare.addCommand(exec("mkdir", ["-p", states]));
    prepare.addCommand(exec("{hipmapPreprocess}",
        [plan.scene, "-o", plan.partition].concat(animation(plan, frame))));
    job.addTask(prepare);

    const merge = author.Task(`merge-${frame}`, "misc");
    for (let first = 0; first < plan.passes; first += plan.chunk) {
        const tasks = addSlice(job, plan, { frame: frame, states: states, first: first }, prepare);
        for (const task of tasks)
            merge.addDependency(task);
        if (first == 0 && plan.chunk < plan.passes)
            addPreview(job, plan, { frame: frame, states: states }, tasks);
    }
    merge.addCommand(exec("{hipmapRender}", ["merge", states,
        "-o", path.join(plan.folder, ofFrame(frame, "image", ".exr")),
        "-o", path.join(plan.folder, ofFrame(frame, "image", ".png")),
        "--stats", path.join(plan.folder, ofFrame(frame, "image", ".json")),
        "--passes", plan.passes]));
    job.addTask(merge);
    return merge;
}

// Adds a task for each tile of some passes.
function addSlice(job, plan, slice, prepare) {
    const count = Math.min(plan.chunk, plan.passes - slice.first);
    const tasks = [];
    for (let tile = 0; tile < plan.tiles; tile++) {
        const name = `${tile}-${slice.first}`;
        const task = author.Task(`render-${slice.frame}-${name}`, "misc");
        const where = plan.tiles > 1 ? ["--tile", `${tile}/${plan.grid}`] : [];
        task.addCommand(exec("{hipmapRender}", [plan.scene, plan.partition].concat(
            animation(plan, slice.frame), where, plan.options,
            ["--first-pass", slice.first, "--passes", count,
             "--state", path.join(slice.states, `${name}.state`)])));
        task.addDependency(prepare);
        job.addTask(task);
        tasks.push(task);
    }
    return tasks;
}

// Adds a task that shows the first passes of a frame, and what else is there by then.
function addPreview(job, plan, slice, tasks) {
    const preview = author.Task(`preview-${slice.frame}`, "misc");
    preview.addCommand(exec("{hipmapRender}", ["merge", slice.states,
        "-o", path.join(plan.folder, ofFrame(slice.frame, "preview", ".png"))]));
    for (const task of tasks)
        preview.addDependency(task);
    job.addTask(preview);
}

function addVideo(job, plan, merges) {
    const task = author.Task("preview-video", "ffmpeg");
    task.addCommand(author.Command("frames-to-video", {
        exe: "ffmpeg",
        fps: plan.fps,
        inputGlob: path.join(plan.folder, "image.*.png"),
        outputFile: path.join(plan.folder, `${path.stem(plan.scene)}.mp4`),
        args: ["-c:v", "h264", "-crf", "20", "-pix_fmt", "yuv420p",
               "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-r", `${plan.fps}`, "-y"],
    }));
    for (const merge of merges)
        task.addDependency(merge);
    job.addTask(task);
}
