# SPDX-License-Identifier: MIT
"""Pieces of work that are done once: in parallel, with progress, kept in files, so that a run can be interrupted.

A piece's key says all that its result depends on (programs by the hash of their content); its result is any JSON
value.
"""
import concurrent.futures
import hashlib
import json
import os
import sys
import time
from pathlib import Path
from typing import Any, Callable, Mapping


class Work:
    """Does pieces and keeps their results in a folder."""

    def __init__(self, folder: Path, quiet: bool = False):
        self._folder = folder
        self._quiet = quiet
        self._hashes: dict[Path, str] = {}
        folder.mkdir(parents=True, exist_ok=True)

    def hash_of(self, path: Path) -> str:
        """The hash of a file's content, read once."""
        if path not in self._hashes:
            self._hashes[path] = hashlib.sha256(path.read_bytes()).hexdigest()
        return self._hashes[path]

    def do(self, title: str, pieces: Mapping[Any, tuple[tuple, Callable[[], Any]]]) -> dict[Any, Any]:
        """Results of `pieces`, a dict from a name to (key, function without arguments), as a dict from names."""
        results, todo = {}, {}
        for name, (key, function) in pieces.items():
            file = self._folder / (hashlib.sha256(repr(key).encode()).hexdigest()[:24] + ".json")
            if file.exists():
                results[name] = json.loads(file.read_text())
            else:
                todo[name] = (file, function)
        begun = time.monotonic()
        self._say(f"{title}: {len(pieces)} pieces, {len(results)} done before")
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            running = {pool.submit(function): (name, file) for name, (file, function) in todo.items()}
            try:
                for done, future in enumerate(concurrent.futures.as_completed(running), 1):
                    name, file = running[future]
                    results[name] = future.result()
                    # Written beside and moved, so that an interrupted run leaves no half result.
                    beside = file.with_suffix(f".{os.getpid()}")
                    beside.write_text(json.dumps(results[name]))
                    beside.replace(file)
                    self._progress(title, done, len(todo), begun, name)
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise
        if todo and sys.stderr.isatty():
            print(file=sys.stderr)
        return {name: results[name] for name in pieces}

    def _say(self, text: str) -> None:
        if not self._quiet:
            print(text, file=sys.stderr, flush=True)

    def _progress(self, title: str, done: int, count: int, begun: float, name: Any) -> None:
        if self._quiet:
            return
        seconds = time.monotonic() - begun
        left = seconds / done * (count - done)
        text = f"  {done} of {count}, about {left:.0f} s left: {' '.join(map(str, name)) if isinstance(name, tuple) else name}"
        if sys.stderr.isatty():
            print(f"\r\033[K{text[:110]}", end="", file=sys.stderr, flush=True)
        elif done == count or done % max(1, count // 10) == 0:
            print(text, file=sys.stderr, flush=True)
