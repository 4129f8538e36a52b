# SPDX-License-Identifier: MIT
"""Pieces of the lab's work: done once, kept, and gone on with after an interruption."""
import tempfile
import unittest
from pathlib import Path

from work import Work


class WorkTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.done = []

    def piece(self, name, key=None):
        def work():
            self.done.append(name)
            return name.upper()
        return (key or name, work)

    def do(self, *names, **keys):
        return Work(self.folder, quiet=True).do("test", {name: self.piece(name, keys.get(name)) for name in names})

    def test_results_come_in_the_order_asked_for(self):
        self.assertEqual(list(self.do("b", "a", "c").items()), [("b", "B"), ("a", "A"), ("c", "C")])

    def test_what_was_done_is_not_done_again(self):
        self.do("a", "b")
        self.assertEqual(self.do("a", "b", "c"), {"a": "A", "b": "B", "c": "C"})
        self.assertEqual(sorted(self.done), ["a", "b", "c"])

    def test_another_key_is_another_piece(self):
        self.do("a")
        self.do("a", a="after a change")
        self.assertEqual(self.done, ["a", "a"])

    def test_an_interrupted_run_keeps_what_was_done_and_nothing_half(self):
        def interrupted():
            raise KeyboardInterrupt
        pieces = {"a": self.piece("a")}
        Work(self.folder, quiet=True).do("test", pieces)
        with self.assertRaises(KeyboardInterrupt):
            Work(self.folder, quiet=True).do("test", {**pieces, "b": ("b", interrupted)})
        self.assertEqual(len(list(self.folder.iterdir())), 1)
        self.assertEqual(self.do("a", "b"), {"a": "A", "b": "B"})
        self.assertEqual(self.done, ["a", "b"])

    def test_a_file_changed_in_content_has_another_hash(self):
        file = self.folder / "program"
        file.write_bytes(b"one")
        one = Work(self.folder, quiet=True).hash_of(file)
        file.write_bytes(b"two")
        self.assertNotEqual(one, Work(self.folder, quiet=True).hash_of(file))
