"""report.html: that it needs no other file, tells what it was given, and works in a browser.

    report_test.py FOLDER_OF_TOOLS SCENE ROOT
"""

import html.parser
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

import tools
from tools import Tools, ToolsTestCase

ROOT = sys.argv[3]
SCENE_NAME = 'a "room" <script>alert(1)</script> & more.glb'
VOID = {"meta", "img", "input", "link", "br"}


class Page(html.parser.HTMLParser):
    """What a page holds: elements in order, text outside of scripts, and whether tags match."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.open, self.words, self.balanced = [], [], [], True
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        self.balanced &= bool(self.open) and self.open.pop() == tag

    def handle_data(self, data):
        if not {"script", "style"} & set(self.open):
            self.words.append(data)

    def all(self, tag):
        return [attributes for name, attributes in self.elements if name == tag]

    def text(self):
        return re.sub(r"\s+", " ", " ".join(self.words))


class Report(ToolsTestCase):
    def setUp(self):
        super().setUp()
        self.out = self.path("out")
        os.mkdir(self.out)

    def in_out(self, name):
        return os.path.join(self.out, name)

    def make_results(self, *options):
        """As pipeline.sh calls the tools, at a small size."""
        scene = self.path(SCENE_NAME.replace("/", "_"))
        shutil.copy(Tools.scene, scene)
        self.succeed("preprocess", scene, "-o", self.in_out("a.hpm"), "--size", "96x72",
                     "--images", self.out, "--candidates", "--json", self.in_out("partition.json"))
        self.succeed("render", scene, self.in_out("a.hpm"), "-o", self.in_out("a.png"), "--size",
                     "48x36", "--photons", 3000, "--error-image", self.in_out("error.png"),
                     "--stats", self.in_out("stats.json"), *options)

    def make_report(self):
        command = [sys.executable, "-B", os.path.join(ROOT, "report/make_report.py"), self.out]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def page(self):
        done = self.make_report()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.in_out("report.html"), encoding="utf-8") as file:
            return Page(file.read())

    def change_statistics(self, change):
        with open(self.in_out("stats.json"), encoding="utf-8") as file:
            stats = json.load(file)
        change(stats)
        with open(self.in_out("stats.json"), "w", encoding="utf-8") as file:
            json.dump(stats, file)
        return stats

    def needs_no_other_file(self, page):
        for tag, attributes in page.elements:
            self.assertNotIn(tag, ("link", "iframe", "object", "embed", "base"))
            for name in ("src", "href", "srcset", "action", "data", "poster"):
                self.assertTrue(attributes.get(name, "data:").startswith("data:"), attributes)
        with open(self.in_out("report.html"), encoding="utf-8") as file:
            text = file.read()
        self.assertNotRegex(text, r"(?i)https?:|@import|url\(|fetch\(|XMLHttpRequest")

    def test_it_tells_which_levels_of_maps_pay(self):
        self.make_results("--integrator", "direct", "--maps", "hierarchical", "--passes", 1)
        text = self.page().text()
        stats = self.change_statistics(lambda stats: None)
        for kind in ("global", "caustic"):
            self.assertIn(stats["photons"][kind]["local"]["decision"], text)

    def test_it_tells_what_it_was_given_and_needs_no_other_file(self):
        self.make_results("--error", "90%")
        page = self.page()
        self.assertTrue(page.balanced and not page.open, page.open)
        self.needs_no_other_file(page)
        text = page.text()
        stats = self.change_statistics(lambda stats: None)
        for sentence in stats["audit"]["found"] + stats["audit"]["assumed"]:
            self.assertIn(sentence, text)
        for title in ("Accuracy and its cost", "Time by stage", "Photons and their maps",
                      "Partition", "Options", "To make it again", "asked for: 90 %"):
            self.assertIn(title, text)
        for effect in stats["effects"]:
            self.assertIn(effect["reason"], text)
        self.assertEqual(len(page.all("script")), 1, "names of files are no scripts")
        self.assertEqual(len(page.all("img")), 6)
        self.assertTrue(all(picture["alt"] for picture in page.all("img")))
        before = stats["error"]["seconds_before"]
        self.assertAlmostEqual(before, stats["seconds"]["rays"] + stats["seconds"]["pilots"])
        self.curve_is_right(page, [{**check, "seconds": before + check["seconds"]}
                                   for check in stats["error"]["checks"]])

    def curve_is_right(self, page, checks):
        """A dot for each check, by the logarithms of time and error."""
        dots = [(float(circle["cx"]), float(circle["cy"])) for circle in page.all("circle")
                if circle["class"] == "dot"]
        self.assertEqual(len(dots), len(checks))
        (x0, y0), (x1, y1) = dots[0], dots[-1]
        first, last = checks[0], checks[-1]
        for (x, y), check in zip(dots, checks):
            along = math.log(check["seconds"] / first["seconds"]) / math.log(
                last["seconds"] / first["seconds"])
            down = math.log(check["error"] / first["error"]) / math.log(
                last["error"] / first["error"])
            self.assertAlmostEqual(x, x0 + along * (x1 - x0), delta=0.2)
            self.assertAlmostEqual(y, y0 + down * (y1 - y0), delta=0.2)
        law = [line for line in page.all("polyline") if line["class"] == "law"][0]
        end = law["points"].split()[-1].split(",")
        self.assertAlmostEqual(float(end[0]), x1, delta=0.2)
        self.assertAlmostEqual(float(end[1]), y1, delta=0.2)

    def test_a_plan_of_effects_is_shown_and_what_is_missing_left_out(self):
        self.make_results("--integrator", "path", "--passes", 2)
        reason = "no <specular> surface is lit"
        self.change_statistics(lambda stats: stats.update(effects=[
            {"name": "caustics", "on": False, "reason": reason, "cost": "none"}]))
        text = self.page().text()
        self.assertIn(reason, text)
        self.assertNotIn("Photons and their maps", text)

        os.remove(self.in_out("partition.json"))
        os.remove(self.in_out("error.png"))

        def forget(stats):
            for name in [name for name in stats if name not in ("error", "passes_done", "image")]:
                del stats[name]
            stats["error"]["checks"] = []
        self.change_statistics(forget)
        page = self.page()
        self.assertTrue(page.balanced)
        self.assertEqual(len(page.all("img")), 1)
        self.assertIn("Not known", page.text())

    def test_light_that_may_be_missing_is_told_where_it_is_much(self):
        self.make_results("--passes", 2)
        for times, told in ((0.5, False), (2, True)):
            def miss(stats, times=times):
                last = stats["error"]["checks"][-1]
                last["missing"] = times * last["error"]
            self.change_statistics(miss)
            self.assertEqual("Light that few samples find may be missing" in self.page().text(), told)

    def test_costs_are_ranges_where_few_samples_find_some_light(self):
        self.make_results("--passes", 2)

        def find_more(stats):
            for price in stats["error"]["prices"]:
                price.update(passes=4, seconds=10, most_passes=11, most_seconds=20)
        self.change_statistics(find_more)
        text = self.page().text()
        self.assertIn("Half this error would take 4 to 11 passes and ", text)
        self.assertEqual(text.count("4 to 11"), 1 + len(self.change_statistics(find_more)["error"]["prices"]))

    def test_pictures_of_another_shape_are_shown_beside(self):
        self.make_results("--passes", 2)
        self.change_statistics(lambda stats: stats["pictures"][0].update(width=48, height=40))
        over = [picture for picture in self.page().all("img") if picture.get("class") == "over"]
        self.assertEqual([picture["alt"].split(":")[0] for picture in over], 4 * ["The same view"])
        self.assertEqual(len(self.page().all("img")), 6)

    def test_what_cannot_be_read_is_named_in_one_line(self):
        for name, content, naming in (("stats.json", None, "stats.json"),
                                      ("stats.json", "{", "stats.json"),
                                      ("stats.json", "[]", "stats.json"),
                                      ("stats.json", '{"error": {}, "passes_done": 1}', ".png"),
                                      ("stats.json", '{"error": {}, "passes_done": 1, "image": '
                                       '{"files": ["x/a.png"]}}', "a.png"),
                                      ("a.png", "not a picture", "a.png")):
            if content is not None:
                with open(self.in_out(name), "w", encoding="utf-8") as file:
                    file.write(content)
            with self.subTest(name=name, content=content):
                done = self.make_report()
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertTrue(done.stderr.startswith("error: "), done.stderr)
                self.assertIn(naming, done.stderr)
                self.assertFalse(os.path.exists(self.in_out("report.html")))

    def shown_by(self, browser):
        """What the browser says of the page, and its errors.  It can fail by itself on a busy machine."""
        command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run",
                   "--disable-background-networking", "--disable-component-update",
                   "--virtual-time-budget=10000", "--dump-dom", "file://" + self.in_out("report.html") + "#self-check"]
        # Processes of it may still write to the profile when the first has ended.
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
            try:
                done = subprocess.run([*command, "--user-data-dir=" + profile], capture_output=True, text=True,
                                      timeout=60, check=False)
            except subprocess.TimeoutExpired as late:
                return "", str(late)
        check = re.search('data-check="([^"]*)"', done.stdout)
        return check[1] if check else "", f"code {done.returncode}: {done.stderr}"

    def test_in_a_browser_pictures_slider_and_choice_work(self):
        browser = shutil.which("chromium")
        if browser is None:
            self.skipTest("no chromium")
        self.make_results("--passes", 3)
        self.page()
        for _ in range(3):
            check, errors = self.shown_by(browser)
            if check:
                break
        self.assertEqual(check, "6 pictures, slider, choice", errors)


if __name__ == "__main__":
    tools.main(sys.argv)
