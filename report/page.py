"""The page as a whole."""

import os

from compare import comparison
from facts import audit, effects, header, how_to_repeat, options, partition, photons
from markup import element, escape
from price import price
from stages import stages

FOLDER = os.path.dirname(os.path.abspath(__file__))


def own_file(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as file:
        return file.read()


def make_page(results):
    """All of it as HTML.  Sections of which nothing is known are left out."""
    stats = results.stats
    parts = [header(results), comparison(results), price(stats),
             element("div", stages(results) + audit(stats), class_="columns"), effects(stats),
             photons(stats), partition(results),
             element("div", options(stats) + how_to_repeat(results), class_="columns")]
    head = ('<meta charset="utf-8"><meta name="viewport" content="width=device-width, '
            'initial-scale=1"><meta name="color-scheme" content="light dark">' +
            element("title", escape(f"{results.title()} \u2013 hipmap")) +
            element("style", own_file("style.css")))
    body = element("main", "\n".join(part for part in parts if part))
    script = element("script", own_file("page.js"))
    return (f'<!DOCTYPE html>\n<html lang="en"><head>{head}</head>\n'
            f"<body>{body}\n{script}</body></html>\n")
