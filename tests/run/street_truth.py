#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Streets of the scanner against their exact truth: what was lost before, on scenes of a second or two."""
import json

from support import RunTest, ilot, main

POINTS = 100000


class StreetTruth(RunTest):
    def judged(self, seed, *settings):
        """The evaluation of a street that was scanned and run, and the truth of its objects."""
        cloud, out = self.folder / f"w{seed}.laz", self.folder / f"o{seed}"
        sets = [word for value in settings for word in ("--set", f"scene.street.{value}")]
        for command in (["scan", "street-wild", "--seed", seed, "--points", POINTS, "-o", cloud, "--overwrite", *sets],
                        ["run", cloud, "-o", out, "--overwrite", "--products", "streets"]):
            done = ilot(*command)
            self.assertIn(done.returncode, (0, 3), done.stderr)
        truth = cloud.with_suffix(".truth.json")
        return json.loads(ilot("evaluate", out, "--truth", truth, "--json").stdout)

    def sensitivity(self, evaluation, name):
        confusion = evaluation["confusion"]
        return confusion["sensitivity"][confusion["classes"].index(name)]

    def test_thin_posts_of_a_tripod(self):
        """None of these lampposts was a candidate: at pixels of 10 cm and more a post has two or three of them."""
        found = 0
        for seed in (701, 702):
            objects = self.judged(seed, "platform=tripod", "cut=whole", "crowns=0")["objects"]["confusion"]
            found += sum(objects["matrix"][objects["classes"].index("lamppost")])
        self.assertGreaterEqual(found, 2)

    def test_walls_of_clouds_that_are_cut_low(self):
        for height in (1.3, 1.8):
            with self.subTest(height=height):
                found = self.judged(700, "platform=vehicle", "cut=cut", f"cut_height={height}", "crowns=0")
                self.assertGreater(self.sensitivity(found, "facade"), 0.35)  # the longer ones; none before
                self.assertGreater(self.sensitivity(found, "ground"), 0.99)


if __name__ == "__main__":
    main(synthetic=[StreetTruth])
