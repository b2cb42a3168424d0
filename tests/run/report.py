#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests report.html from outside: what it links is there, what it holds is what the run wrote, and it needs nothing else."""
import base64
import html.parser
import json
import os
import pathlib
import re
import subprocess
import unittest
import urllib.parse
import zlib

from support import EXE, SANITIZED, RunTest, ilot, main


class Page(html.parser.HTMLParser):
    """Links, anchors and packed data of a page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.ids, self.data, self.name = [], set(), {}, None
        self.text = pathlib.Path(path).read_text(encoding="utf-8")
        self.feed(self.text)
        self.data = {name: zlib.decompress(base64.b64decode(text)) for name, text in self.data.items()}

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if "id" in values:
            self.ids.add(values["id"])
        for key in ("href", "src"):
            link = values.get(key)
            if link and not link.startswith("data:image/"):
                self.links.append(link)
        self.name = values.get("data-ilot") if tag == "script" else None

    def handle_data(self, text):
        if self.name:
            self.data[self.name] = self.data.get(self.name, "") + text

    def json(self, name):
        return json.loads(self.data[name])


def without_resources(text):
    """The page without the section of seconds, threads and memory."""
    return re.sub(r'<section id="stages">.*?</section>', "", text, flags=re.S)


class Report(RunTest):
    def reported(self, inputs, *arguments, out="out"):
        """Runs with a report. Returns the page and the folder."""
        out = self.folder / out
        done = subprocess.run([EXE, "run", *map(str, inputs if isinstance(inputs, list) else [inputs]), "-o", str(out),
                               *map(str, arguments)], capture_output=True, text=True, timeout=300)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        self.assertIn(f"open {out}/report.html", done.stderr)
        return Page(out / "report.html"), out

    def whole(self, page, out):
        """Every file is linked and there, every anchor exists, and nothing comes from elsewhere."""
        run = json.loads((out / "run.json").read_text())
        linked = {urllib.parse.unquote(link) for link in page.links if not link.startswith("#")}
        self.assertEqual(linked, {file["path"] for file in run["results"]})
        for name in linked:
            self.assertTrue((out / name).is_file(), name)
        for link in page.links:
            if link.startswith("#") and "/" not in link:
                self.assertIn(link[1:], page.ids)
        self.assertNotRegex(re.sub(r'xmlns="[^"]*"', "", page.text.split("<script")[0]), r'(src|href)="(https?:)?//')
        return run

    def test_planes_and_roofs(self):
        cloud = self.district(120000)
        page, out = self.reported(cloud, "--products", "planes,roofs")
        run = self.whole(page, out)
        features = [json.loads(line) for line in (out / "roofs" / "roofs.city.jsonl").read_text().splitlines()[1:]]
        buildings = page.json("buildings")
        self.assertEqual(buildings["id"], [feature["id"] for feature in features])
        of = [feature["CityObjects"][feature["id"]]["attributes"] for feature in features]
        self.assertEqual(buildings["unit"], [a["unit_id"] for a in of])
        quality = buildings["quality"]
        self.assertEqual([quality["words"][i] for i in quality["rows"]],
                         [a["quality"] if a["status"] != "footprint_only" else "none" for a in of])
        self.assertEqual(len(page.json("planes")["id"]), run["counts"]["planes"])
        scene = page.json("scene")
        self.assertEqual(scene["points"]["of"], 120000)
        self.assertEqual(scene["points"]["count"], 120000)  # fewer than the bound: all of them
        names = [column["name"] for column in scene["points"]["columns"]]
        self.assertEqual(names[:3], ["x", "y", "z"])
        self.assertIn("plane", names)
        self.assertEqual(sum(tile["buildings"] for tile in scene["building_tiles"]),
                         sum(bool(f["CityObjects"][f["id"]]["geometry"]) for f in features))
        for chosen in run["chosen"]:
            self.assertIn(f"<code>{chosen['key']}</code>", page.text)
        self.assertIn(run["result_hash"], page.text)
        self.assertLess((out / "report.html").stat().st_size, 6_000_000)

        # The same result gives the same page, made again and with another number of threads.
        self.assertEqual(ilot("report", out, "--threads", "1").returncode, 0)
        self.assertEqual((out / "report.html").read_text(), page.text)
        again, _ = self.reported(cloud, "--products", "planes,roofs", "--threads", "1", out="one")
        self.assertEqual(without_resources(again.text), without_resources(page.text))

    def test_facades_and_streets(self):
        cloud, arguments = self.facade(150000, "facade-restoration")
        page, out = self.reported(cloud, *arguments)
        run = self.whole(page, out)
        facades = page.json("facades")
        self.assertEqual(len(facades), run["counts"]["facades"]["facades"])
        self.assertEqual(sum(len(f["elements"]) for f in facades), run["counts"]["facades"]["elements"])
        for facade in facades:
            self.assertIn(f"facade/{facade['id']}", page.ids)
        self.assertIn("data:image/jpeg;base64,", page.text)
        street = self.scan("street", 150000, blocks=2)
        page, out = self.reported(street, "--products", "streets", out="street")
        run = self.whole(page, out)
        self.assertEqual(len(page.json("street")["objects"]), run["counts"]["streets"]["objects"])

    def test_names_are_no_markup(self):
        cloud = self.district(40000)
        evil = self.folder / "<img src=x onerror=alert(1)> & 'b' é.las"
        evil.write_bytes(cloud.read_bytes())
        page, out = self.reported(evil, "--products", "roofs", "--no-clouds")
        self.whole(page, out)
        self.assertNotIn("<img src=x", page.text)
        self.assertIn("no labelled clouds", page.json("scene")["points"]["problem"])

    def test_what_it_refuses_and_leaves_out(self):
        self.assertEqual(ilot("report", self.folder).returncode, 2)
        self.assertIn("no run.json", ilot("report", self.folder / "none").stderr)
        cloud = self.district(40000)
        _, out = self.reported(cloud)
        before = json.loads((out / "run.json").read_text())["result_hash"]
        done = ilot("run", cloud, "-o", out, "-q", "--overwrite")  # which adds --no-report
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse((out / "report.html").exists(), "a report of an older result is none of this one")
        self.assertEqual(json.loads((out / "run.json").read_text())["result_hash"], before)

    @unittest.skipIf(SANITIZED, "sanitizers need memory of their own")
    def test_memory(self):
        """A report keeps to the memory of its run."""
        cloud = self.district(2_000_000)
        out, _ = self.work(cloud, "--products", "planes,roofs", "--memory", "96M")
        child = subprocess.Popen([EXE, "report", str(out)], stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        self.assertEqual(status, 0)
        self.assertLessEqual(usage.ru_maxrss, 96 << 10, "KiB")


if __name__ == "__main__":
    main(synthetic=[Report])
