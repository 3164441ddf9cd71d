#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`glext-emu devices`: the proposed machines, and what query hardware is built of."""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

LAUNCHER = sys.argv[1]
del sys.argv[1:]
DOCUMENT = pathlib.Path(__file__).resolve().parents[2] / "docs" / "hardware.md"
PARTS = ("register_bits", "adders", "adder_bits", "comparators", "comparator_bits", "gates")
MACHINE = """name = "{name}"
description = "d"
source = "s"
[extensions]
emulate = ["GL_EMU_occlusion_unit", "GL_EMU_depth_region_query"]
[unit]
pipes = {pipes}
counter_bits = {bits}
"""


def launch(*arguments):
    return subprocess.run([LAUNCHER, *arguments], capture_output=True, text=True, timeout=60)


def costs(*names):
    told = launch("devices", "--cost", "--json", *names)
    assert told.returncode == 0, told.stderr
    return {device["name"]: {row["hardware"]: row for row in device["cost"]} for device in json.loads(told.stdout)}


def cost_of(pipes, bits):
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(MACHINE.format(name="mine", pipes=pipes, bits=bits))
        file.flush()
        return costs(file.name)["mine"]


class ProposedMachines(unittest.TestCase):
    def setUp(self):
        self.devices = {device["name"]: device for device in json.loads(launch("devices", "--json").stdout)}

    def test_one_machine_asks_of_one_region_the_other_of_many(self):
        one, many = self.devices["proposed-zfar"], self.devices["proposed-zfar-parallel"]
        self.assertEqual(one["emulate"], ["GL_EMU_depth_region_query"])
        self.assertEqual(one["region"]["max_regions"], 1)
        # Every tile of 1280x960 in tiles of 32x32.
        self.assertGreaterEqual(many["region"]["max_regions"], 1280 // 32 * (960 // 32))
        # Hey et al. had no occlusion query at all, and a machine with one region more than theirs has none either.
        self.assertEqual({key: many[key] for key in ("emulate", "hide", "gl_version")},
                         {key: one[key] for key in ("emulate", "hide", "gl_version")})
        self.assertIn("GL_ARB_occlusion_query", one["hide"])

    def test_the_unit_stands_on_a_machine_that_keeps_its_queries(self):
        unit, base = self.devices["proposed-occlusion-unit"], self.devices["geforce-fx-5950"]
        self.assertEqual(unit["emulate"], ["GL_EMU_occlusion_unit"])
        self.assertEqual((unit["hide"], unit["gl_version"]), (base["hide"], base["gl_version"]))
        self.assertNotIn("GL_ARB_occlusion_query", unit["hide"])


class Cost(unittest.TestCase):
    def test_each_machine_has_the_hardware_that_it_emulates(self):
        hardware = {name: list(rows) for name, rows in costs().items()}
        self.assertEqual(hardware["native"], [])
        self.assertEqual(hardware["visualize-fx"], ["HP flag"])
        self.assertEqual(hardware["geforce3"], ["HP flag", "NV counter"])
        self.assertEqual(hardware["geforce-fx-5950"], ["ARB counter"])
        self.assertEqual(hardware["proposed-zfar"], ["region query"])
        self.assertEqual(hardware["proposed-occlusion-unit"][-1], "Occlusion Unit")

    def test_the_unit_is_the_sum_of_its_registers_and_a_queue(self):
        rows = costs("proposed-occlusion-unit")["proposed-occlusion-unit"]
        unit, registers = rows["Occlusion Unit"], [row for name, row in rows.items() if name[0] == "+"]
        self.assertEqual(len(registers), 5)
        for place in ("each_pipe", "shared"):
            for part in PARTS:
                self.assertEqual(unit[place][part], sum(row[place][part] for row in registers), (place, part))
        # 64 records: two pointers of 6 bits, and the bit that tells full from empty.
        self.assertEqual(unit["queue"]["register_bits"],
                         sum(row["queue"]["register_bits"] for row in registers) + 2 * 6 + 1)
        for part in PARTS:
            self.assertEqual(unit["total"][part],
                             8 * unit["each_pipe"][part] + unit["shared"][part] + unit["queue"][part])

    def test_it_follows_the_devices_numbers(self):
        one, two = cost_of(1, 32)["Occlusion Unit"], cost_of(2, 32)["Occlusion Unit"]
        self.assertEqual(one["each_pipe"], two["each_pipe"])
        self.assertEqual(two["total"]["comparators"] - one["total"]["comparators"], 5 + 5)  # in the pipe, in the tree
        narrow = cost_of(1, 8)["+ projected hits"]
        self.assertEqual(narrow["each_pipe"]["register_bits"], 8)
        self.assertEqual(narrow["queue"]["register_bits"], 64 * 8)

    def test_the_table_holds_the_same_numbers(self):
        lines = launch("devices", "--cost", "geforce3").stdout.splitlines()
        row = costs("geforce3")["geforce3"]["NV counter"]
        words = next(line for line in lines if "NV counter" in line).split()
        wanted = [row[place][part] for place in ("each_pipe", "shared", "queue")
                  for part in ("register_bits", "adder_bits", "comparator_bits", "gates")]
        self.assertEqual([int(word) for word in words[-12:]], wanted)

    def test_the_document_shows_what_the_command_prints(self):
        command = "proposed-occlusion-unit proposed-zfar proposed-zfar-parallel geforce3".split()
        blocks = DOCUMENT.read_text().split("```")
        at = next(i for i, block in enumerate(blocks) if " ".join(["devices --cost", *command]) in block)
        shown = [line.rstrip() for line in blocks[at + 2].strip("\n").splitlines()[1:]]
        printed = [line.rstrip() for line in launch("devices", "--cost", *command).stdout.splitlines()]
        self.assertEqual(shown, printed)

    def test_bad_use_is_one_sentence_and_status_2(self):
        for arguments, words in ((["--cost", "voodoo"], "there is no device `voodoo`"),
                                 (["geforce3"], "--cost")):
            with self.subTest(arguments):
                result = launch("devices", *arguments)
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertIn(words, result.stderr)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)


if __name__ == "__main__":
    unittest.main()
