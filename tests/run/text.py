#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests text clouds as people write them: dialects, strays, digits."""
import json
import pathlib

from support import RunTest, ilot, main

FORMS = ["651000,123;6861000,456;55,1\n651001,5;6861000,456;55,25\n",
         "651000,123\t6861000,456\t55,1\n651001,5\t6861000,456\t55,25\n",
         "651000,123 6861000,456 55,1\n651001,5 6861000,456 55,25\n",
         "x;y;z\n651000,123;6861000,456;55,1\n651001,5;6861000,456;55,25\n"]


class TextTest(RunTest):
    def written(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def converted(self, source, *more, code=0):
        target = self.folder / "converted.csv"
        done = ilot("convert", source, target, "--overwrite", *more)
        self.assertEqual(done.returncode, code, done.stderr)
        lines = target.read_text().splitlines()[1:] if code == 0 else []
        return [[float(v) for v in line.split(",")[:3]] for line in lines], done.stderr

    def test_decimal_commas(self):
        for form in FORMS:
            for suffix in ("txt", "csv", "xyz", "pts"):
                rows, output = self.converted(self.written(f"a.{suffix}", form))
                self.assertEqual(rows, [[651000.123, 6861000.456, 55.1], [651001.5, 6861000.456, 55.25]], form)
                self.assertIn("decimal comma", output)
                run_json = json.loads(ilot("info", "--json", self.folder / f"a.{suffix}").stdout)[0]
                self.assertIn("decimal comma", run_json["dialect"])

    def test_two_readings_are_refused_and_chosen(self):
        path = self.written("a.txt", "1,234;5,678;9,012\n2,345;5,678;9,012\n")
        for verb in (["convert", path, self.folder / "b.csv"], ["info", path], ["run", path, "-o", self.folder / "o"]):
            done = ilot(*verb)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("--text-dialect semicolon,decimal-comma", done.stderr)
            self.assertIn("1234 | 5678 | 9012", done.stderr)
        rows, _ = self.converted(path, "--text-dialect", "semicolon,decimal-comma")
        self.assertEqual(rows[0], [1.234, 5.678, 9.012])
        rows, _ = self.converted(path, "--text-dialect", "semicolon,thousands-comma")
        self.assertEqual(rows[0], [1234, 5678, 9012])
        self.assertEqual(ilot("info", path, "--text-dialect", "semikolon").returncode, 2)

    def test_run_says_the_dialect_and_gives_the_planes_of_points(self):
        rows = [(651000 + i * 0.25, 6861000 + j * 0.25, 50 + i * 0.05) for i in range(60) for j in range(60)]
        plain = "".join(f"{x:.3f} {y:.3f} {z:.3f}\n" for x, y, z in rows)
        point = self.written("a.xyz", plain)
        comma = self.written("b.xyz", plain.replace(".", ",").replace(" ", ";"))
        zeros = self.written("c.xyz", "0 0 0\n" * 1200 + plain)
        results = [self.work(path, "--crs", "EPSG:2154", out=self.folder / path.stem) for path in (point, comma, zeros)]
        tables = [(out / "planes.csv").read_bytes() for out, _ in results]
        self.assertEqual(tables[0].count(b"\n"), 2)
        self.assertEqual(tables[1], tables[0])
        self.assertEqual(tables[2], tables[0])
        self.assertIn("decimal comma", results[1][1]["inputs"][0]["dialect"])
        self.assertEqual(results[2][1]["counts"]["points"]["rejected"], 1200)
        done = ilot("run", comma, "-o", self.folder / "d", "--crs", "EPSG:2154")
        self.assertIn("separated by semicolons, decimal comma", done.stderr)

    def test_one_stray_keeps_the_digits(self):
        path = self.written("zf.xyz", "0 0 0\n" + "".join(f"651000.{i:04} 6861000.25 50.003\n" for i in range(500)))
        done = ilot("convert", path, self.folder / "z.csv")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("1 row is 0 0 0", done.stderr)
        self.assertIn("651000.0001,6861000.25,50.003", (self.folder / "z.csv").read_text())


if __name__ == "__main__":
    main(synthetic=[TextTest])
