"""Sends a DICOM clip of insonate-cli to a DICOM archive, and compares the stored clip.

pacs_test.py CLI: CLI is the program. Exit status 77: the package dcmtk is not here.
"""

import pathlib
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest

CLI = sys.argv.pop(1)
PROGRAMS = ("storescp", "storescu", "dcmconv", "dcmdump")
# Pixel spacing, and the tags of the sequence of ultrasound regions.
CALIBRATION = ("(0028,0030)", "(0018,60")


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def run(*command):
    return subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout


def dataset_of(file, folder):
    """Returns the bytes of a DICOM file without its header, and with all sequences in one encoding."""
    plain = folder / (file.name + ".plain")
    run("dcmconv", "--write-dataset", "--write-xfer-little", "--length-explicit", file, plain)
    return plain.read_bytes()


def calibration_of(file):
    lines = [line.strip() for line in run("dcmdump", "--quiet", file).splitlines()]
    # The length of the sequence may be encoded in two ways.
    return [line for line in lines if line.startswith(CALIBRATION) and " SQ " not in line]


class Archive(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "attempt.json").write_text('{"acts": [{"probe": "auto"}, {"wait_s": 0.5}]}')
        run(CLI, "phantom", self.folder / "case")
        run(CLI, "session", self.folder / "case", "--script", self.folder / "attempt.json", "--record", self.folder / "attempt")
        self.clip = self.folder / "clip.dcm"
        run(CLI, "video", self.folder / "attempt", self.folder / "case", "--fps", "4", "--out", self.clip)

    def start_archive(self):
        port, stored = free_port(), self.folder / "archive"
        stored.mkdir()
        archive = subprocess.Popen(["storescp", "--output-directory", str(stored), str(port)])
        self.addCleanup(archive.wait)
        self.addCleanup(archive.terminate)
        return port, stored

    def send(self, port):
        for _ in range(100):
            if subprocess.run(["storescu", "127.0.0.1", str(port), str(self.clip)], capture_output=True).returncode == 0:
                return
            time.sleep(0.1)
        self.fail("the archive does not take the clip")

    def test_the_archive_has_the_clip_as_it_was_saved(self):
        port, stored = self.start_archive()
        self.send(port)
        files = list(stored.iterdir())
        self.assertEqual(len(files), 1)
        calibration = calibration_of(files[0])
        self.assertEqual(calibration, calibration_of(self.clip))
        self.assertTrue(any("PhysicalDeltaX" in line for line in calibration))
        self.assertTrue(any("PixelSpacing" in line for line in calibration))
        self.assertEqual(dataset_of(files[0], self.folder), dataset_of(self.clip, self.folder))


if __name__ == "__main__":
    if not all(shutil.which(program) for program in PROGRAMS):
        sys.exit(77)
    unittest.main()
