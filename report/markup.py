"""HTML text and numbers as the report writes them."""

import html
import math

BLANK = "\u00a0"  # does not break


def escape(text):
    return html.escape(str(text), quote=True)


def element(name, content="", **attributes):
    """An element whose content is HTML already; attributes are escaped.  class_ is class."""
    written = "".join(f' {key.rstrip("_").replace("_", "-")}="{escape(value)}"'
                      for key, value in attributes.items() if value is not None)
    return f"<{name}{written}>{content}</{name}>"


def img(**attributes):
    return element("img", **attributes).removesuffix("</img>")


def listing(sentences):
    return element("ul", "".join(element("li", escape(sentence)) for sentence in sentences))


def table(head, rows, **attributes):
    """head: words.  rows: cells that are HTML already; the first of each is its heading."""
    top = "".join(element("th", escape(word), scope="col") for word in head)
    body = "".join(element("tr", element("th", row[0], scope="row") +
                           "".join(element("td", cell) for cell in row[1:])) for row in rows)
    whole = element("table", element("thead", element("tr", top)) + element("tbody", body),
                    **attributes)
    return element("div", whole, class_="scroll", tabindex="0")


def section(title, content, **attributes):
    return element("section", element("h2", escape(title)) + content, **attributes)


def percent(share):
    """As render prints it: "3.2 %" of 0.032, with a blank that does not break."""
    value = 100 * share
    if value >= 1:
        return f"{value:.{1 if value < 10 else 0}f}{BLANK}%"
    return f"{value:.2g}{BLANK}%"


def number(value):
    """12345 as "12,345", with blanks that do not break."""
    if not math.isfinite(value):
        return "never"
    if value != int(value):
        return f"{value:.3g}"
    return f"{int(value):,}".replace(",", "\u202f")


def duration(seconds):
    """In the unit that suits: "3.1 ms", "74 s", "12 min", "3.4 h", "12 days"."""
    if seconds is None or not math.isfinite(seconds):
        return "never"
    for unit, size, most in (("ms", 1e-3, 1), ("s", 1, 120), ("min", 60, 7200),
                             ("h", 3600, 172800)):
        if seconds < most:
            return f"{short(seconds / size)}{BLANK}{unit}"
    return f"{short(seconds / 86400)}{BLANK}days"


def short(value):
    """Two digits, or three if there are more before the point."""
    return f"{value:.2g}" if 0 < value < 9.95 else f"{value:.0f}"


def memory(size):
    return f"{number(round(size / 2 ** 20))}{BLANK}MiB"
