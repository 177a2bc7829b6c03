"""Group F: files that are no files, that may not be read, that have odd names, or that are far larger than memory."""

import os
import shutil
import struct
import subprocess
import threading
import unittest

from encoded_meshes import ply_ascii, ply_binary, small_mesh, written_base
from faults import ALL_FACES, OLD, OUTPUTS, PROGRAM, SANITIZED, FaultTest, measure

MESH = small_mesh()
NOBODY = 65534
SPARSE = 5 << 30


class OddFiles(FaultTest):
    group = "F files"

    def refused(self, name, says, code=3, **options):
        before = self.files()
        run = self.simplify(name, "--faces", ALL_FACES, **options)
        self.expect_reason(run, code, name, says)
        self.expect_modest(run, 0)
        for output in OUTPUTS:
            self.assertEqual((self.folder / output).read_bytes(), OLD)
        self.assertEqual(self.files(), before)

    def test_a_file_that_is_empty(self):
        for suffix in ("ply", "obj", "off", "stl"):
            with self.case(suffix=suffix):
                (self.folder / f"empty.{suffix}").touch()
                self.refused(f"empty.{suffix}", r"\Athe file is empty\Z")

    def test_a_file_that_is_blank(self):
        for suffix, code, says in (
            ("ply", 3, "a PLY file starts"),
            ("obj", 4, "no faces"),
            ("off", 3, "an OFF file starts"),
            ("stl", 3, "neither ascii STL"),
        ):
            for text in (b"\n", b" \r\n\t\n" * 1000):
                with self.case(suffix=suffix, text=text[:3]):
                    (self.folder / f"blank.{suffix}").write_bytes(text)
                    if suffix == "stl" and len(text) > 84:
                        says = "triangles take"
                    self.refused(f"blank.{suffix}", says, code)

    def test_a_file_that_is_missing(self):
        for name in ("none.ply", "none/scan.ply", "base.ply/scan.ply", "./none.obj"):
            with self.case(name=name):
                self.refused(name, r"\A(No such file or directory|Not a directory)\Z")

    def test_a_link_that_leads_nowhere_or_round(self):
        for name, target, says in (
            ("nowhere.ply", "none.ply", "No such file"), ("loop.ply", "loop.ply", "Too many levels of symbolic links")
        ):
            with self.case(name=name):
                (self.folder / name).symlink_to(target)
                self.refused(name, says)

    def test_a_link_to_a_scan_is_read(self):
        with self.case(name="link.ply"):
            (self.folder / "data.bin").write_bytes(ply_ascii(MESH).data)
            (self.folder / "link.ply").symlink_to("data.bin")
            self.assertEqual(self.simplify("link.ply", "--faces", ALL_FACES).code, 0)
            self.assertEqual(written_base(self.folder / "base.ply"), MESH)

    def test_a_folder(self):
        with self.case(name="folder.ply"):
            (self.folder / "folder.ply").mkdir()
            self.refused("folder.ply", r"\Ais a folder\Z")
            (self.folder / "folder.ply").rmdir()

    def test_a_device_or_a_pipe(self):
        for device in ("zero", "null", "full", "urandom", "tty"):
            with self.case(device=device):
                (self.folder / "device.ply").symlink_to(f"/dev/{device}")
                self.refused("device.ply", "is not a regular file|No such device")
        with self.case(device="pipe that nobody writes"):
            os.mkfifo(self.folder / "pipe.ply")
            self.refused("pipe.ply", "is not a regular file")
        with self.case(device="pipe that somebody writes"):
            os.mkfifo(self.folder / "pipe.ply")
            writer = os.open(self.folder / "pipe.ply", os.O_RDWR)
            os.write(writer, ply_ascii(MESH).data)
            self.refused("pipe.ply", "is not a regular file")
            os.close(writer)
        with self.case(device="standard input"):
            (self.folder / "stdin.ply").symlink_to("/dev/stdin")
            self.refused("stdin.ply", "is not a regular file")

    def test_a_file_that_may_not_be_read(self):
        with self.case(name="secret.ply"):
            (self.folder / "secret.ply").write_bytes(ply_ascii(MESH).data)
            (self.folder / "secret.ply").chmod(0)
            if os.geteuid() != 0:
                self.refused("secret.ply", r"\APermission denied\Z")
                return
            self.folder.chmod(0o777)
            run = self.as_nobody("info", "secret.ply")
            self.expect_reason(run, 3, "secret.ply", r"\APermission denied\Z")

    def as_nobody(self, *arguments):
        """Permissions do not bind root: the run is another user's, if that one may start the program."""
        try:
            subprocess.run([PROGRAM, "--version"], user=NOBODY, check=True, capture_output=True)
        except (PermissionError, subprocess.CalledProcessError):
            self.skipTest("another user may not start the program")
        return measure(arguments, self.folder, user=NOBODY)

    def test_names_of_any_kind(self):
        names = (
            "two\nlines.ply", "größe 日本 \U0001f600.ply", "n" * 200 + ".ply", "n" * 251 + ".ply", "-dash.ply", "--faces.ply", " .ply",
            "a\tb.ply", "'quoted\".ply", "*?[a].ply", "%s%n.ply", "{}{0}.ply", "..ply", "a.b.c.ply", "\\.ply", "$HOME.ply", ".ply.ply",
            "\x7f\x1b[31m.ply", "x.PLY", "~.ply", "info.ply", "base.ply.ply",
        )  # fmt: skip
        for name in names:
            with self.case(name=name):
                self.expect_accepted(name, ply_ascii(MESH).data, MESH)
        for name in names:
            with self.case(name=name, output=True):
                (self.folder / "scan.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", encoding="ascii")
                run = measure(["simplify", "--quiet", f"--output={name}", "--", "scan.off"], self.folder)
                self.assertEqual((run.code, run.stderr), (0, ""))
                self.assertEqual(self.files(), sorted((*OUTPUTS, "scan.off", name)))
                self.assertEqual(len(written_base(self.folder / name)[1]), 1)

    def test_a_name_that_is_no_utf_8(self):
        name = os.fsdecode(b"\xff\xfe.ply")
        with self.case(name="bytes"):
            (self.folder / name).write_bytes(ply_ascii(MESH).data)
            self.assertEqual(self.simplify(name, "--faces", ALL_FACES).code, 0)
            self.assertEqual(self.json_of("report.json")["input"]["path"], "\ufffd\ufffd.ply")

    def test_a_control_character_of_a_name_does_not_break_the_message(self):
        for name in ("two\nlines.ply", "a\r\x1b[2J.ply"):
            with self.case(name=name):
                (self.folder / name).write_bytes(b"ply\n")
                run = self.simplify(name)
                self.assertEqual(run.code, 3)
                self.assertRegex(run.stderr, r"\Afoldless: [^\x00-\x1f]+\n\Z")

    def test_a_path_that_is_too_long(self):
        deep = "d/" * 2100 + "scan.ply"
        for name in ("n" * 300 + ".ply", deep):
            with self.case(length=len(name)):
                run = self.simplify(name)
                self.assertEqual(run.code, 3)
                self.assertIn("File name too long", run.stderr)
                for outputs in (
                    ["-o", name], ["-o", "other.ply", "--report", name], ["-o", "other.ply", "--correspondence", name]
                ):
                    run = measure(["simplify", "missing.ply", *outputs], self.folder)
                    self.assertEqual(run.code, 5, run.stderr)
                self.assertEqual(self.files(), sorted(OUTPUTS))

    @unittest.skipIf(SANITIZED, "sanitizers bound what can be mapped")
    def test_five_gigabytes_of_nothing(self):
        for suffix, says in (
            ("ply", "byte 0x00 is not text"),
            ("obj", "byte 0x00 is not text"),
            ("off", "byte 0x00 is not text"),
            ("stl", r"\Abyte 80: 0 triangles"),
        ):
            with self.case(suffix=suffix):
                with open(self.folder / f"sparse.{suffix}", "wb") as file:
                    file.truncate(SPARSE)
                self.refused(f"sparse.{suffix}", says)

    @unittest.skipIf(SANITIZED, "sanitizers bound what can be mapped")
    def test_a_scan_behind_five_gigabytes_that_are_skipped(self):
        whole = ply_binary(MESH)
        header, data = whole.data[: whole.edges[2]], whole.data[whole.edges[2] :]
        header = header.replace(b"element vertex", f"element junk {SPARSE}\nproperty uchar a\nelement vertex".encode("ascii"))
        with self.case(what="skipped"):
            with open(self.folder / "sparse.ply", "wb") as file:
                file.write(header)
                file.seek(SPARSE, os.SEEK_CUR)
                file.write(data)
            run = self.simplify("sparse.ply", "--faces", ALL_FACES)
            self.assertEqual(run.code, 0, run.stderr)
            self.assertEqual(written_base(self.folder / "base.ply"), MESH)
            self.expect_modest(run, len(whole.data))
        with self.case(what="cut"):
            with open(self.folder / "sparse.ply", "wb") as file:
                file.write(header)
                file.truncate(SPARSE + len(header) + len(data) - 1)
            self.refused("sparse.ply", r"\Abyte \d{10}: ")

    @unittest.skipIf(SANITIZED, "sanitizers bound what can be mapped")
    def test_more_vertices_or_faces_than_an_index_can_name(self):
        """The files are as large as they claim, so that only the limit is in the way."""
        vertex = b"property uchar x\nproperty uchar y\nproperty uchar z\n"
        for what, header, size, says in (
            (
                "ply",
                b"ply\nformat binary_little_endian 1.0\nelement vertex 2147483648\n" + vertex + b"end_header\n",
                7 << 30,
                "2147483648 vertices are too many",
            ),
            ("off", b"OFF\n2147483648 0 0\n", 13 << 30, "the vertices or faces are too many"),
            ("off", b"OFF\n0 1431655766 0\n", 3 << 30, "the vertices or faces are too many"),
        ):  # fmt: skip
            with self.case(format=what, says=says):
                with open(self.folder / f"many.{what}", "wb") as file:
                    file.write(header)
                    file.truncate(size)
                self.refused(f"many.{what}", says)

    @unittest.skipIf(SANITIZED, "sanitizers bound what can be mapped")
    def test_an_stl_that_claims_more_than_it_has(self):
        with self.case(count=2**32 - 1):
            with open(self.folder / "claim.stl", "wb") as file:
                file.write(b"x" * 80 + struct.pack("<I", 2**32 - 1))
                file.truncate(SPARSE)
            self.refused("claim.stl", r"\Abyte 80: 4294967295 triangles take 214748364834 bytes")

    def test_a_file_that_is_shortened_while_it_is_read(self):
        """The system ends the program with SIGBUS, or the reader sees the shorter file; nothing is left in either case."""
        points, faces = MESH
        rows = b"# a comment to read over\n" * 200000
        with self.case(what="shortened"):
            (self.folder / "scan.off").write_bytes(b"OFF\n" + rows + b"22 40 0\n")
            timer = threading.Timer(0.01, os.truncate, (self.folder / "scan.off", 10))
            timer.start()
            run = self.simplify("scan.off")
            timer.join()
            self.assertIn(run.code, (3, -7), run.stderr)
            self.expect_old_outputs("scan.off")

    def test_a_file_system_without_room_for_a_map(self):
        """/proc has files of size 0 that are not empty: they count as empty, as their size says."""
        with self.case(what="/proc"):
            if not os.path.exists("/proc/cpuinfo"):
                self.skipTest("there is no /proc")
            (self.folder / "proc.ply").symlink_to("/proc/cpuinfo")
            self.refused("proc.ply", "the file is empty")

    def tearDown(self):
        for path in self.folder.iterdir():
            if path.is_dir():
                shutil.rmtree(path)


if __name__ == "__main__":
    unittest.main()
