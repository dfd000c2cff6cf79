"""Whether `render` keeps what `--quote` promises: passes and seconds to an error."""

WITHIN = 1.5  # times, of a promise
PATIENCE = 4  # times the passes that were promised, after which a render is given up


def promised(price, what):
    """The range (least, most) of "passes" or "seconds" in a price of the statistics."""
    return price[what], price.get(f"most_{what}", price[what])


def held(span, taken):
    least, most = span
    return least / WITHIN <= taken <= most * WITHIN


def written(span, form):
    least, most = span
    return f"{least:{form}}" + (f" to {most:{form}}" if most > least else "")
