"""The picture with others laid over it, divided by a line that can be dragged."""

from markup import element, escape, img, section

# Name of a picture's file: what it is called, and what it shows.
KNOWN = {
    "error": ("Error", "the relative error of each pixel, in false colour"),
    "shared_maps": ("Shared maps", "the faces that share photons, in a colour for each map"),
    "edges": ("Edges", "the edges of faces by class"),
    "candidates": ("Local maps", "the faces that are expected to get a map of their own, by photons"),
    "groups": ("Group maps", "the patches of faces that are expected to get a map together"),
}


def title_of(picture):
    return KNOWN.get(picture.name, (picture.name, ""))[0]


def described(picture):
    return KNOWN.get(picture.name, ("", picture.name))[1]


def comparison(results):
    image, overlays = results.image, results.overlays
    under = img(class_="under", src=image.uri(), width=image.width, height=image.height,
                alt=f"The picture rendered from {results.title()}")
    if not overlays:
        return section("The picture", element("div", under, class_="view", style=ratio(image)))
    over = "".join(overlay(picture, i) for i, picture in enumerate(overlays))
    slider = ('<input type="range" min="0" max="100" value="50" step="0.5" '
              'aria-label="How much of the rendered picture is seen, in percent">'
              '<span class="divider" aria-hidden="true"></span>')
    labels = (element("span", "Render", class_="label left", aria_hidden="true") +
              element("span", escape(title_of(overlays[0])), class_="label right",
                      aria_hidden="true"))
    view = element("div", under + over + slider + labels, class_="view",
                   style="--cut:50%;" + ratio(image))
    return section("The picture", view + chooser(overlays) +
                   "".join(legend(picture, i) for i, picture in enumerate(overlays)))


def ratio(image):
    return f"--ratio:{image.width}/{image.height}"


def overlay(picture, index):
    """Its legend lies below the view and is cut off; `legend` has it in words."""
    return img(class_="over", src=picture.uri(), hidden="" if index else None,
               alt=f"The same view: {described(picture)}")


def gallery(pictures):
    """Pictures that cannot be laid over the rendered one, each with its legend below it."""
    figures = "".join(element("figure", img(src=picture.uri(), alt=described(picture)) +
                              element("figcaption", escape(title_of(picture) + ": " +
                                                           described(picture)) + "."))
                      for picture in pictures)
    return element("div", figures, class_="columns gallery") if figures else ""


def chooser(overlays):
    choices = "".join(
        element("label", f'<input type="radio" name="over" value="{i}"' +
                (" checked" if i == 0 else "") + ">" +
                element("span", escape(title_of(picture))))
        for i, picture in enumerate(overlays))
    return element("fieldset", element("legend", "Compare with") + choices)


def legend(picture, index):
    entries = "".join(element("li", swatch(entry["colours"]) + escape(entry["text"]))
                      for entry in picture.legend)
    words = element("p", escape(described(picture)[:1].upper() + described(picture)[1:]) + ".")
    return element("div", words + element("ul", entries), class_="legend",
                   hidden="" if index else None)


def swatch(colours):
    if not colours:
        return ""
    if len(colours) == 1:
        return element("span", class_="swatch", style=f"background:{colours[0]}")
    return element("span", class_="swatch scale",
                   style=f"background:linear-gradient(90deg,{','.join(colours)})")
