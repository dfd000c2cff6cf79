"use strict";

const view = document.querySelector(".view");
const slider = view.querySelector("input[type=range]");
const choices = [...document.querySelectorAll("input[name=over]")];
const overlays = [...view.querySelectorAll(".over")];
const legends = [...document.querySelectorAll(".legend")];

function divide() {
  view.style.setProperty("--cut", slider.value + "%");
}

function choose(index) {
  overlays.forEach((picture, i) => { picture.hidden = i !== index; });
  legends.forEach((legend, i) => { legend.hidden = i !== index; });
  view.querySelector(".label.right").textContent = choices[index].nextElementSibling.textContent;
}

// For tests: report.html#self-check says in an attribute of <html> what works.
async function checkSelf() {
  const pictures = [...document.images];
  await Promise.all(pictures.map((picture) => picture.decode()));
  const wrong = [];
  for (const cut of ["25", "50"]) {
    slider.value = cut;
    slider.dispatchEvent(new Event("input"));
    if (!getComputedStyle(overlays[0]).clipPath.includes(cut + "%")) wrong.push("slider");
  }
  choices.toReversed().forEach((choice) => {
    choice.click();
    const shown = overlays.filter((picture) => getComputedStyle(picture).display !== "none");
    if (shown.length !== 1 || shown[0] !== overlays[choice.value]) wrong.push("choice");
  });
  return wrong.length ? "wrong: " + wrong.join(", ") : pictures.length + " pictures, slider, choice";
}

if (slider) {
  slider.addEventListener("input", divide);
  choices.forEach((choice, i) => choice.addEventListener("change", () => choose(i)));
  divide();
  choose(Math.max(choices.findIndex((choice) => choice.checked), 0));
}
if (location.hash === "#self-check") {
  checkSelf().then((found) => { document.documentElement.dataset.check = found; },
                   (problem) => { document.documentElement.dataset.check = "wrong: " + problem; });
}
