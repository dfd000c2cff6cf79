"""Charts of what the simulations found.  Needs matplotlib (Debian: python3-matplotlib)."""

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot

# What machines do, from what makes the image to what is waited for.
KINDS = {"passes": ("passes", "#2f6db3"), "pilots": ("pilots", "#7fb2dc"), "load": ("start and load", "#3a8f4b"),
         "queue": ("queue", "#9ccf9f"), "save": ("states and images", "#d99a1c"), "add": ("adding up films", "#b3412e"),
         "merge": ("merge", "#b3412e"), "wait": ("waiting", "#cccccc")}


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    pyplot.close(figure)


def draw_times(lines, path):
    """lines: name -> machines -> seconds; the first is that of no loss."""
    figure, axes = pyplot.subplots(figsize=(8, 4.6))
    styles = [("--", "#888888", None), ("-", "#b3412e", "o"), ("-", "#d99a1c", "s"), ("-", "#7fb2dc", "^"),
              ("-", "#2f6db3", "D")]
    for (name, times), (line, colour, marker) in zip(lines.items(), styles):
        axes.plot(list(times), list(times.values()), line, color=colour, marker=marker, markersize=4, label=name)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_ylim(bottom=min(min(times.values()) for times in list(lines.values())[1:]) / 4)
    axes.set_xlabel("machines")
    axes.set_ylabel("seconds")
    axes.grid(alpha=0.25, which="both")
    axes.legend()
    save(figure, path)


def draw_shares(panels, path):
    """panels: title -> machines -> outcome."""
    figure, all_axes = pyplot.subplots(1, len(panels), figsize=(10, 4.4), sharey=True)
    for axes, (title, outcomes) in zip(all_axes, panels.items()):
        names = [name for name in KINDS if any(out.spent.get(name, 0) > 0 for out in outcomes.values())]
        axes.stackplot(list(outcomes), [[100 * out.share(name) for out in outcomes.values()] for name in names],
                       labels=[KINDS[name][0] for name in names], colors=[KINDS[name][1] for name in names])
        axes.set_xscale("log")
        axes.set_xlim(min(outcomes), max(outcomes))
        axes.set_ylim(0, 100)
        axes.set_title(title)
        axes.set_xlabel("machines")
        axes.legend(loc="lower left", fontsize=8)
    all_axes[0].set_ylabel("% of the machines' time")
    save(figure, path)
