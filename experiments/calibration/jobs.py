"""What is to be done, in stages, each of which needs what the stages before it found; and what came
of it."""

import runs
from notebook import Job

# A reference takes about so many times what an image does.
REFERENCE_WEIGHT = 25


def target_key(scene, integrator):
    return f"target/{runs.named(scene)}/{integrator}"


def reference_key(scene, method):
    return f"reference/{runs.named(scene)}/{method.name}"


def image_key(scene, integrator, seed):
    return f"image/{runs.named(scene)}/{integrator}/{seed}"


def sharing(scene, method):
    """The integrators whose images are compared with this reference, whether asked for or not: so it
    is the same one whichever are."""
    return [name for name in runs.integrators_for(scene, runs.INTEGRATORS)
            if runs.reference_method(scene, name) == method]


def methods(scene, integrators):
    """How the references of these are rendered."""
    return list(dict.fromkeys(runs.reference_method(scene, name)
                              for name in runs.integrators_for(scene, integrators)))


def target(lab, scene, integrator):
    return Job(target_key(scene, integrator), 1, lambda: lab.find_target(scene, integrator))


def reference(lab, notebook, scene, method):
    """Good enough for the strictest target."""
    def make():
        wanted = min(notebook[target_key(scene, name)] for name in sharing(scene, method))
        return lab.make_reference(scene, method, wanted)
    return Job(reference_key(scene, method), REFERENCE_WEIGHT, make)


def image(lab, notebook, scene, integrator, seed):
    def render():
        known = notebook[reference_key(scene, runs.reference_method(scene, integrator))]
        return lab.try_image(scene, integrator, notebook[target_key(scene, integrator)], seed,
                             known["noise2"])
    return Job(image_key(scene, integrator, seed), 1, render)


def stages(lab, notebook, scenes, integrators, seeds):
    """[[Job]]: those of a stage in any order, at the same time."""
    wanted = [(scene, method) for scene in scenes for method in methods(scene, integrators)]
    # The longest first, so that none is left for one core alone.
    wanted.sort(key=lambda pair: pair[1] is not runs.LONG_PROGRESSIVE)
    return [[target(lab, scene, name) for scene, method in wanted
             for name in sharing(scene, method)],
            [reference(lab, notebook, scene, method) for scene, method in wanted],
            [image(lab, notebook, scene, name, seed) for scene in scenes
             for name in runs.integrators_for(scene, integrators) for seed in range(seeds)]]


def cases(notebook, seeds):
    """What its runs were, and each image's true error and interval, of every scene and integrator
    that the notebook has all of."""
    found = []
    for scene in sorted(runs.SCENES.written()):  # nothing is known of the others
        for integrator in runs.integrators_for(scene, runs.INTEGRATORS):
            method = runs.reference_method(scene, integrator)
            keys = [image_key(scene, integrator, seed) for seed in range(seeds)]
            if all(key in notebook for key in keys):
                found.append({"scene": scene, "integrator": integrator,
                              "target": notebook[target_key(scene, integrator)],
                              "reference": method.name,
                              "reference_error": notebook[reference_key(scene, method)]["error"],
                              "images": [notebook[key] for key in keys]})
    return found
