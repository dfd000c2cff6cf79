"""Axes of plots of error against processor seconds; needs matplotlib."""

from matplotlib import ticker


def draw_curve(axes, points, style, label):
    """points: (seconds, error, spread of the error).  style: colour and line."""
    seconds, errors, spreads = zip(*points)
    colour, line = style
    axes.errorbar(seconds, [100 * error for error in errors], yerr=[100 * spread for spread in spreads],
                  fmt=line, color=colour, label=label, markersize=4, linewidth=1.3, capsize=2)


def scale_axes(axes):
    """Both logarithmic, with plain numbers."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(ticker.NullFormatter())
    axes.grid(which="both", alpha=0.2)
