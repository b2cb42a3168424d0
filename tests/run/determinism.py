#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Invariants 1 to 4: threads, instruction sets, blocks, memory and the order of files have no effect on the result."""
import collections
import json
import re
import struct

from support import Las, RunTest, ilot, main, real

WAYS = [
    ["--threads", "1"], ["--threads", "2"], ["--threads", "3"], ["--threads", "8"],
    ["--block-points", "4096", "--threads", "2"], ["--block-points", "65536"], ["--block-points", "1048576"],
    ["--block-points", "67108864"], ["--memory", "96M", "--threads", "2"], ["--memory", "4G"],
    ["--memory", "96M", "--block-points", "2000", "--threads", "3"],
]
FEW_WAYS = [["--threads", "1"], ["--block-points", "2000", "--threads", "3"], ["--block-points", "65536", "--threads", "8"],
            ["--memory", "96M", "--threads", "2"]]
ISAS = json.loads(ilot("--version", "--json").stdout)["isas"]  # that the machine has; by default a run takes the best

COLUMN_HEADER = 16  # bytes


def contacts(out):
    """Returns how often planes of neighbouring cells touch. The join decides from these counts."""
    sums = collections.Counter()
    for path in (out / ".store" / "blocks").glob("*.contacts"):
        values = path.read_bytes()[COLUMN_HEADER:]
        for a, b, count in struct.iter_unpack("<III", values):
            sums[a, b] += count
    return sums


class Determinism(RunTest):
    def same_in_ways(self, inputs, ways, *arguments):
        """Expects one result with all options and all instruction sets. Returns the run.json of a run without
        either."""
        run_json = {" ".join(way): self.work(inputs, *arguments, *way)[1] for way in ways}
        run_json |= {isa: self.work(inputs, *arguments, env={"ILOT_FORCE_ISA": isa})[1] for isa in ISAS}
        run_json["again"] = self.work(inputs, *arguments)[1]
        hashes = {way: record["result_hash"] for way, record in run_json.items()}
        self.assertEqual(len(set(hashes.values())), 1, hashes)
        self.assertGreater(max(record["blocks"] for record in run_json.values()), 20, "there were blocks to tell apart")
        counts = run_json["again"]["counts"]["points"]
        self.assertGreater(counts["labelled"], 0.5 * counts["read"])
        return run_json["again"]

    def same_all_ways(self, inputs):
        self.assertGreater(self.same_in_ways(inputs, WAYS)["counts"]["planes"], 20)

    def parts(self, cloud, cut, names="abc"):
        """Splits the cloud into three files. Returns them and the positions of the records per file."""
        records = cloud.records()
        places = [[], [], []]
        for i in range(len(records)):
            places[cut(i, len(records))].append(i)
        files = [cloud.write(self.folder / f"{name}.las", [records[i] for i in part])
                 for name, part in zip(names, places)]
        return files, places

    def labels_in_parts(self, cloud, cut, names):
        """Returns labels and planes.csv of a run over three files, in the order of the whole cloud."""
        files, places = self.parts(cloud, cut, names)
        out, _ = self.work(files, "--block-points", "8192")
        labels = [None] * cloud.count
        for name, part in zip(names, places):
            for i, label in zip(part, self.labelled(out, name).labels()):
                labels[i] = label
        return labels, (out / "planes.csv").read_bytes()

    def same_in_any_files(self, path):
        cloud = Las.read(path)
        out, _ = self.work(path)
        whole = self.labelled(out, path.stem).labels(), (out / "planes.csv").read_bytes()
        for cut in (lambda i, n: min(2, 3 * i // n), lambda i, n: i % 3):
            for names in ("abc", "cab"):
                self.assertTrue(whole == self.labels_in_parts(cloud, cut, names), names)
        files, _ = self.parts(cloud, lambda i, n: i % 3)
        first = self.work(files)[1]["result_hash"]
        self.assertEqual(first, self.work(files[::-1], "--threads", "3")[1]["result_hash"])


    def methods(self):
        """Returns the names that planes.method accepts, from its line of help."""
        lines = ilot("run", "--print-config").stdout.splitlines()
        help_line = lines[next(i for i, line in enumerate(lines) if line.startswith("method =")) - 1]
        return re.search(r"; (.*) or \"auto\"", help_line).group(1).split(", ")


class Synthetic(Determinism):
    def test_every_method(self):
        cloud = self.district(40000)
        self.assertGreater(len(self.methods()), 7)
        for method in self.methods():
            with self.subTest(method):
                asked = ["--set", f"planes.method={method}"]
                run_json = [self.work(cloud, *asked, "--threads", "1")[1],
                        self.work(cloud, *asked, "--block-points", "4096", "--threads", "3")[1],
                        self.work(cloud, *asked, env={"ILOT_FORCE_ISA": "baseline"})[1]]
                self.assertEqual(len({t["result_hash"] for t in run_json}), 1)
                self.assertGreater(run_json[0]["counts"]["planes"], 3)

    def test_same_all_ways(self):
        self.same_all_ways(self.district(150000))

    def test_facades(self):
        cloud, asked = self.facade(60000)
        run_json = self.same_in_ways(cloud, FEW_WAYS, *asked)
        self.assertEqual(run_json["counts"]["facades"]["facades"], 1)
        self.assertGreater(run_json["counts"]["facades"]["elements"], 20, "there was something to tell apart")

    def test_streets(self):
        cloud, asked = self.street(150000)
        run_json = self.same_in_ways(cloud, FEW_WAYS, *asked)
        self.assertGreater(run_json["counts"]["streets"]["objects"], 20, "there was something to tell apart")
        self.assertGreater(run_json["counts"]["streets"]["blocks"], 20)

    def test_any_files(self):
        self.same_in_any_files(self.district(100000))

    def test_shapes_and_density(self):
        """Tests what only terrestrial scans have, with known stations."""
        path = self.folder / "shapes.laz"
        self.assertEqual(ilot("scan", "shapes", "--points", "150000", "-o", path, "-q").returncode, 0)
        asked = ["--stations", self.folder / "shapes.stations.csv"]
        hashes = set()
        for way in (["--threads", "1"], ["--threads", "3", "--block-points", "8192"], ["--memory", "96M"]):
            out, run_json = self.work(path, *asked, *way)
            hashes.add(run_json["result_hash"])
            self.assertGreater(run_json["counts"]["shapes"], 5)
            self.assertEqual(len(list((out / "density").glob("*.tif"))), 4)
        _, run_json = self.work(path, *asked, env={"ILOT_FORCE_ISA": "baseline"})
        self.assertEqual(hashes, {run_json["result_hash"]})

    def test_each_point_twice(self):
        cloud = Las.read(self.district(60000))
        files = [cloud.write(self.folder / name) for name in ("a.las", "b.las")]
        hashes = {self.work(files, *way)[1]["result_hash"] for way in ([], ["--block-points", "1000", "--threads", "3"])}
        self.assertEqual(len(hashes), 1)
        out, _ = self.work(files[::-1])
        self.assertTrue(self.labelled(out, "a").labels() == self.labelled(out, "b").labels(), "equal points, equal labels")

    def test_density_that_changes_from_cell_to_cell(self):
        cloud = Las.read(self.district(150000))
        shift = [round(o / s) for o, s in zip(cloud.offset, cloud.scale)]
        kept = [record for i, (record, (x, y, _)) in enumerate(zip(cloud.records(), cloud.raw()))
                if ((x + shift[0] >> 15) + (y + shift[1] >> 15)) % 2 == 0 or i % 9 == 0]
        path = cloud.write(self.folder / "uneven.las", kept)
        ways = [self.work(path, "--keep-store", "--block-points", points) for points in (1500, 8192, 1048576)]
        self.assertEqual(len({run_json["result_hash"] for _, run_json in ways}), 1)
        first, *others = [contacts(out) for out, _ in ways]
        self.assertGreater(len(first), 50)
        for other in others:
            self.assertEqual(first, other)


class Real(Determinism):
    def test_urban_tile(self):
        self.same_all_ways(real("ign/77050_627755_pf6.las"))

    def test_coloured_tile(self):
        self.same_all_ways(real("ign/870000_6618000.las"))

    def test_both_together(self):
        self.same_all_ways([real("ign/870000_6618000.las"), real("ign/77050_627755_pf6.las")])

    def test_any_files(self):
        self.same_in_any_files(real("ign/77050_627755_pf6.las"))


if __name__ == "__main__":
    main(synthetic=[Synthetic], real=[Real])
