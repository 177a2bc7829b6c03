"""Group E: files that are not what they seem, and odd but honest ones, which are read to the last bit."""

import bz2
import lzma
import os
import struct
import unittest

from encoded_meshes import (
    ENCODINGS,
    TEXTS,
    changed,
    compressed,
    content,
    encoded,
    extension,
    obj,
    off,
    ply_ascii,
    ply_big_endian,
    ply_binary,
    small_mesh,
    stl_ascii,
    stl_binary,
)
from faults import MEGABYTE, PLACE, Case, FaultTest, at_byte, at_line
from layouts import FIRST_PLY_LINE, HARMLESS, ply_bytes_with, ply_with

MESH = small_mesh()
POINTS, FACES = MESH
LONG = b"x" * MEGABYTE


class Honest(FaultTest):
    """Files that a person expects to work."""

    group = "E honest files"

    def test_texts_may_be_laid_out_in_many_ways(self):
        for name in TEXTS:
            for how, change in HARMLESS.items():
                if how == "empty lines" and name == "obj":
                    how = "empty lines in obj"
                with self.case(encoding=name, how=how):
                    data = change(encoded(name, MESH).data)
                    self.expect_accepted(f"layout.{extension(name)}", data, content(name, MESH))

    def test_headers_of_bytes_may_be_laid_out_in_many_ways(self):
        for name in ("ply little endian", "ply big endian"):
            whole = encoded(name, MESH)
            header, data = whole.data[: whole.edges[2]], whole.data[whole.edges[2] :]
            for how in (
                "CR LF", "CR only", "tabs", "a byte order mark", "many blanks", "blanks behind each line", "empty lines"
            ):
                if how == "empty lines":
                    head = header.removesuffix(b"\n").replace(b"\n", b"\n\n") + b"\n"
                else:
                    head = HARMLESS[how](header)
                with self.case(encoding=name, how=how):
                    self.expect_accepted("layout.ply", head + data, MESH)

    def test_data_behind_a_header_may_begin_with_a_line_end(self):
        for first in (b"\n\n\0\0", b"\r\n\0\0", b"\n\r\n\0", b"\r\r\r\r"):
            x = struct.unpack("<f", first)[0]
            mesh = [(x, 0.0, 1.0), *POINTS[1:]], FACES
            for how in ("as it is", "CR LF", "CR only"):
                with self.case(first=first, how=how):
                    whole = ply_binary(mesh)
                    header, data = whole.data[: whole.edges[2]], whole.data[whole.edges[2] :]
                    self.expect_accepted("start.ply", HARMLESS[how](header) + data, mesh)

    def test_bytes_may_end_with_a_line_end(self):
        for name in ("ply little endian", "ply big endian"):
            for end in (b"\n", b"\r\n", b" \n\n"):
                with self.case(encoding=name, end=end):
                    self.expect_accepted("end.ply", encoded(name, MESH).data + end, MESH)

    def test_extensions_may_be_in_any_case(self):
        for name in ENCODINGS:
            for spelled in (extension(name).upper(), extension(name).title()):
                with self.case(encoding=name, extension=spelled):
                    self.expect_accepted(f"scan.{spelled}", encoded(name, MESH).data, content(name, MESH))

    def test_a_binary_stl_may_start_with_solid(self):
        for header in (
            b"solid", b"solid ascii", b"SOLID x\nfacet normal 0 0 1\n", b"  solid", b"\xef\xbb\xbfsolid", b"", b"\xff" * 80
        ):
            with self.case(header=header):
                self.expect_accepted("solid.stl", stl_binary(MESH, header).data, content("stl binary", MESH))

    def test_attributes_and_normals_of_a_binary_stl_are_ignored(self):
        data = bytearray(stl_binary(MESH).data)
        for at in range(84, len(data), 50):
            data[at : at + 12] = struct.pack("<3f", float("nan"), float("inf"), 7.0)
            data[at + 48 : at + 50] = b"\xff\x7f"
        with self.case(what="attributes"):
            self.expect_accepted("attributes.stl", bytes(data), content("stl binary", MESH))

    def test_comments_may_be_as_long_as_they_like(self):
        name = stl_ascii(MESH).data
        texts = {
            "comment.ply": changed(
                ply_ascii(MESH).data, FIRST_PLY_LINE, FIRST_PLY_LINE + b"comment " + LONG + b"\nobj_info " + LONG + b"\n"
            ),
            "bytes.ply": changed(
                ply_binary(MESH).data, FIRST_PLY_LINE, FIRST_PLY_LINE + b"comment end_header\ncomment " + LONG + b"\n"
            ),
            "comment.obj": b"# " + LONG + b"\n" + changed(obj(MESH).data, b"\n", b" #" + LONG + b"\n"),
            "comment.off": b"#" + LONG + b"\n" + changed(off(MESH).data, b"\n", b" # 1 2 3 " + LONG + b"\n", 2),
            "name.stl": changed(name, b"small mesh", LONG) + b" " + LONG + b"\n",
        }
        for file, data in texts.items():
            with self.case(file=file):
                mesh = content("stl ascii" if file.endswith("stl") else "ply ascii", MESH)
                self.expect_accepted(file, data, mesh)

    def test_comments_may_hold_any_bytes(self):
        for text in (b"\xff\xfe\x80", "größe 日本".encode("utf-8"), b"\x01\x02\x1b[31m", b"\0\0", b"\\", b"f 1 2 3"):
            for file, data in (
                ("any.ply", changed(ply_ascii(MESH).data, FIRST_PLY_LINE, FIRST_PLY_LINE + b"comment " + text + b"\n")),
                ("any.obj", b"#" + text + b"\n" + obj(MESH).data + b"# " + text),
                ("any.off", b"#" + text + b"\n" + off(MESH).data + b"# " + text),
            ):
                with self.case(file=file, text=text):
                    self.expect_accepted(file, data, MESH)

    def test_elements_that_are_not_known_are_skipped(self):
        rows = b"1 2 0.5 3 7 8 9\n" * 3
        properties = b"property int a\nproperty list uchar float b\nproperty list int uchar c\n"
        for place in ("before", "between", "after"):
            with self.case(place=place, format="ascii"):
                of_element = {place: b"element extra 3\n" + properties}
                index = ("before", "between", "after").index(place)
                lines = tuple(b"1 2 0.5 3 1 7\n" * 3 if i == index else b"" for i in range(3))
                self.expect_accepted("extra.ply", ply_with(**of_element, rows=lines), MESH)
            with self.case(place=place, format="ascii", rows="too long"):
                lines = tuple(rows if i == index else b"" for i in range(3))
                self.expect_refused(Case(place, "extra.ply", ply_with(**of_element, rows=lines), 3, PLACE + "c is missing"))

    def test_elements_that_are_not_known_are_skipped_in_bytes(self):
        for encode, order in ((ply_binary, "<"), (ply_big_endian, ">")):
            whole = encode(MESH)
            cuts = [0, *whole.edges]
            start, vertex, face, vertices, faces = (whole.data[a:b] for a, b in zip(cuts, cuts[1:]))
            face = face.removesuffix(b"end_header\n")
            lists = b"element extra 3\nproperty list uchar double b\nproperty short c\n"
            listed = b"".join(struct.pack(f"{order}B{n}dh", n, *[0.5] * n, -1) for n in (0, 1, 3))
            plain = b"element plain 2\nproperty double a\nproperty uchar b\n"
            plainly = struct.pack(order + "dB", 1.5, 10) * 2
            for order_of in ("before", "between", "after"):
                with self.case(place=order_of, encode=encode.__name__):
                    headers = {"before": b"", "between": b"", "after": b""} | {order_of: lists + plain}
                    data = {"before": b"", "between": b"", "after": b""} | {order_of: listed + plainly}
                    parts = [start, headers["before"], vertex, headers["between"], face, headers["after"], b"end_header\n"]
                    parts += [data["before"], vertices, data["between"], faces, data["after"]]
                    self.expect_accepted("extra.ply", b"".join(parts), MESH)

    def test_faces_may_come_before_vertices(self):
        whole = ply_binary(MESH)
        cuts = [0, *whole.edges]
        start, vertex, face, vertices, faces = (whole.data[a:b] for a, b in zip(cuts, cuts[1:]))
        face = face.removesuffix(b"end_header\n")
        with self.case(order="faces first"):
            self.expect_accepted("order.ply", b"".join([start, face, vertex, b"end_header\n", faces, vertices]), MESH)

    def test_properties_that_are_not_known_are_skipped(self):
        for order in "<>":
            for count in (0, 1, 3, 255):
                with self.case(order=order, values=count):
                    data = ply_bytes_with(order, lambda i, n=count: [i] * n, lambda i, n=count: [0.25] * n)
                    self.expect_accepted("extra.ply", data, MESH)

    def test_normals_and_base_mesh_properties_of_a_scan_are_ignored(self):
        data = ply_ascii(MESH).data
        data = changed(data, b"property float z\n", b"property float z\nproperty float nx\nproperty int scan_vertex\n")
        data = changed(data, b"vertex_indices\n", b"vertex_indices\nproperty float t_min\n")
        header, rows = data.split(b"end_header\n")
        rows = rows.splitlines()
        rows = [row + b" nan -7" for row in rows[: len(POINTS)]] + [row + b" inf" for row in rows[len(POINTS) :]]
        with self.case(what="base mesh"):
            self.expect_accepted("base_like.ply", header + b"end_header\n" + b"\n".join(rows), MESH)

    def test_double_coordinates_keep_each_bit(self):
        mesh = [tuple(x / 3 for x in point) for point in POINTS], FACES
        for encode in (ply_binary, ply_big_endian, ply_ascii):
            with self.case(encode=encode.__name__):
                self.expect_accepted("double.ply", encode(mesh, vertex="double").data, mesh)
        for name in ("obj", "off", "stl ascii"):
            with self.case(encoding=name):
                self.expect_accepted(f"double.{extension(name)}", encoded(name, mesh).data, content(name, mesh))

    def test_names_of_ply_types_with_sizes_mean_the_same(self):
        for old, new in ((b"float", b"float32"), (b"uchar", b"uint8"), (b"list uchar int", b"list uint8 int32")):
            for encode in (ply_binary, ply_big_endian, ply_ascii):
                with self.case(old=old, encode=encode.__name__):
                    self.expect_accepted("sizes.ply", encode(MESH).data.replace(old, new), MESH)
        mesh = [tuple(x / 3 for x in point) for point in POINTS], FACES
        with self.case(old="double"):
            data = ply_binary(mesh, vertex="double", length="int", index="uint").data
            data = data.replace(b"double", b"float64").replace(b"list int uint", b"list int32 uint32")
            self.expect_accepted("sizes.ply", data, mesh)
        with self.case(old="short"):
            data = ply_binary(MESH, length="short", index="ushort").data
            self.expect_accepted("sizes.ply", data.replace(b"list short ushort", b"list int16 uint16"), MESH)
        with self.case(old="char"):
            data = ply_binary(MESH, length="char", index="char").data
            self.expect_accepted("sizes.ply", data.replace(b"list char char", b"list int8 int8"), MESH)

    def test_obj_may_say_more_than_positions_and_faces(self):
        more = (
            b"mtllib a b.mtl\no thing\ng one two\ns 1\ns off\nusemtl red\nvt 0.5 0.5\nvt 1\nvn 0 0 1\nvn nan 0 0\nvp 1 2\n"
            b"p 1 2\nl 1 2 3\ncstype bezier\nunknown_word 1 2 3\n_x\nAn unknown word\nvt not a number\n"
        )
        data = obj(MESH).data
        with self.case(what="statements"):
            self.expect_accepted("more.obj", more + data.replace(b"f ", more + b"f "), MESH)
        with self.case(what="colours"):
            self.expect_accepted(
                "more.obj", b"\n".join(r + b" 0.5 1 255" if r[:1] == b"v" else r for r in data.split(b"\n")), MESH
            )
        with self.case(what="weights"):
            self.expect_accepted("more.obj", b"\n".join(r + b" 1.0" if r[:1] == b"v" else r for r in data.split(b"\n")), MESH)
        with self.case(what="continued lines"):
            self.expect_accepted("more.obj", data.replace(b"f ", b"f \\\n").replace(b"v ", b"v\\\r\n "), MESH)
        with self.case(what="the old name of f"):
            self.expect_accepted("more.obj", data.replace(b"f ", b"fo "), MESH)

    def test_off_may_say_more_than_positions_and_faces(self):
        data = off(MESH).data
        header, body = data.split(b"\n", 1)
        rows = body.splitlines()
        vertices, faces = rows[1 : 1 + len(POINTS)], rows[1 + len(POINTS) :]
        for keyword, extra in (
            (b"COFF", b" 255 0 0 255"),
            (b"NOFF", b" 0 0 1"),
            (b"STOFF", b" 0.5 0.5"),
            (b"STCNOFF", b" 1 2 3 4 5 6 7 8 9"),
            (b"OFF", b" 0.1 0.2 0.3"),
        ):
            with self.case(keyword=keyword):
                text = [keyword, rows[0], *(v + extra for v in vertices), *faces]
                self.expect_accepted("more.off", b"\n".join(text) + b"\n", MESH)
        with self.case(what="colours of faces"):
            text = [header, rows[0], *vertices, *(face + b" 0.1 0.2 0.3 1" for face in faces)]
            self.expect_accepted("more.off", b"\n".join(text) + b"\n", MESH)
        with self.case(what="counts behind the keyword"):
            self.expect_accepted("more.off", data.replace(b"OFF\n", b"OFF "), MESH)
            self.reset_folder()
            self.expect_accepted("more.off", data.replace(b"OFF\n", b"OFF"), MESH)

    def test_stl_keywords_may_be_in_any_case_and_place(self):
        data = stl_ascii(MESH).data
        for how, text in (
            ("upper case", data.upper()),
            ("one line each token", changed(data, b"solid small mesh", b"solid").replace(b" ", b"\n")),
            (
                "all in few lines",
                data.replace(
                    b"\nouter loop\nvertex", b" outer loop vertex"
                ).replace(b"\nendloop\nendfacet", b" endloop endfacet"),
            ),
            ("no name", changed(data, b"solid small mesh", b"solid")),
            ("two solids", data.replace(b"endsolid", b"endsolid small mesh\nsolid other\nendsolid other")),
        ):
            with self.case(how=how):
                self.expect_accepted("words.stl", text, content("stl ascii", MESH))


class Lies(FaultTest):
    """Files that are not what they say."""

    group = "E lies"

    def refused(self, file, data, says, code=3):
        with self.case(file=file, says=says):
            self.expect_refused(Case(says, file, data, code, says))

    def test_the_byte_order_is_swapped(self):
        little, big = ply_binary(MESH).data, ply_big_endian(MESH).data
        self.refused("swapped.ply", changed(little, b"little", b"big"), at_byte(r"\d+", "vertex index .* is out of range"))
        self.refused("swapped.ply", changed(big, b"big", b"little"), at_byte(r"\d+", "vertex index .* is out of range"))
        for kind in ("short", "ushort", "int", "uint"):
            little, big = (encode(MESH, length=kind).data for encode in (ply_binary, ply_big_endian))
            self.refused(
                "swapped.ply", changed(little, b"little", b"big"), at_byte(r"\d+", "list 'vertex_indices' cannot have")
            )
            self.refused("swapped.ply", changed(big, b"big", b"little"), at_byte(r"\d+", "list 'vertex_indices' cannot have"))

    def test_text_and_bytes_are_swapped(self):
        for encode, form in ((ply_binary, b"binary_little_endian"), (ply_big_endian, b"binary_big_endian")):
            self.refused("bytes.ply", changed(encode(MESH).data, form, b"ascii"), PLACE)
            self.refused("text.ply", changed(ply_ascii(MESH).data, b"ascii", form), PLACE)
        binary = stl_binary(MESH).data
        self.refused("text.stl", b"solid" + binary[5:-1], PLACE)
        self.refused("bytes.stl", stl_ascii(MESH).data.replace(b"solid", b"dense"), at_byte(80, ".* triangles take"))

    def test_the_extension_is_wrong(self):
        for name in ENCODINGS:
            for other in ("ply", "obj", "off", "stl"):
                if other != extension(name):
                    self.refused(f"{name.replace(' ', '_')}.{other}", encoded(name, MESH).data, PLACE)

    def test_the_extension_is_unknown(self):
        for file in ("scan.xyz", "scan", "scan.ply.bak", "scan.plyx", "scan.", ".ply", "scan.gltf", "scan.glb", "scan.ply.gz"):
            with self.case(file=file):
                (self.folder / file).write_bytes(ply_ascii(MESH).data)
                self.expect_reason(self.simplify(file), 3, file, "unknown file type; .ply, .obj, .off and .stl can be read")
                self.expect_old_outputs(file)

    def test_the_file_is_compressed(self):
        for name in ENCODINGS:
            file = f"packed.{extension(name)}"
            with self.case(encoding=name):
                (self.folder / file).write_bytes(compressed(encoded(name, MESH).data))
                self.expect_reason(self.simplify(file), 3, file, r"\Acompressed with gzip; decompress it first\Z")
                self.expect_old_outputs(file)
            for pack in (bz2.compress, lzma.compress):
                self.refused(file, pack(encoded(name, MESH).data), PLACE)

    def test_the_text_is_utf_16(self):
        for name in TEXTS:
            for code in ("utf-16", "utf-16-le", "utf-16-be", "utf-32"):
                self.refused(f"wide.{extension(name)}", encoded(name, MESH).data.decode("ascii").encode(code), PLACE)

    def test_a_text_has_a_nul_or_another_byte_that_is_no_text(self):
        for name in TEXTS:
            data = encoded(name, MESH).data
            place = data.rindex(b"0.0")
            line = data.count(b"\n", 0, place) + 1
            for byte in (b"\0", b"\1", b"\x1a", b"\x1b"):
                for position in (place, place + 3):
                    text = data[:position] + byte + data[position:]
                    says = at_line(line, f"(byte 0x{byte[0]:02x} is not text|'.*' for|. is missing)")
                    self.refused(f"nul.{extension(name)}", text, says)
            for byte in (b"\x7f", b"\x80", b"\xff", b"\xc2\xa0"):
                self.refused(
                    f"high.{extension(name)}",
                    data[:place] + byte + data[place:],
                    at_line(line, "'[?]+0.0' for . is not a number"),
                )

    def test_there_is_something_behind_the_end(self):
        for name in ("ply ascii", "off"):
            data = encoded(name, MESH).data
            for behind in (b"0", b"0 0 0\n", b"3 0 1 2\n", b"garbage\n", b"\0"):
                self.refused(
                    f"behind.{extension(name)}", data + behind, at_line(data.count(b"\n") + 1, "data behind the last|byte 0x00")
                )
        for name in ("ply little endian", "ply big endian"):
            data = encoded(name, MESH).data
            for behind in (b"\0", b"x", b"\n\0", b"\0" * 4096, data):
                at = len(data) + (1 if behind[:1] == b"\n" else 0)
                self.refused("behind.ply", data + behind, at_byte(at, "data behind the last element"))
        for behind in (b"\0", b"\n", b"\0" * 49, b"\0" * 50, b"\0" * 51):
            self.refused(
                "behind.stl", stl_binary(MESH).data + behind, at_byte(80, "40 triangles take 2084 bytes, but the file has")
            )
        data = stl_ascii(MESH).data
        for behind in (b"\ngarbage", b"\nfacet", b"\nendsolid", b"\nvertex 0 0 0"):
            self.refused("behind.stl", data + behind, at_line(data.count(b"\n") + 2, "'.*' stands where 'solid' should stand"))
        data = obj(MESH).data
        for behind in (b"0 0 0\n", b"@@\n", b"3\n", b"\0\n", b"(f 1 2 3)\n"):
            self.refused(
                "behind.obj", data + behind, at_line(data.count(b"\n") + 1, "is no OBJ statement|'.*' is no|byte 0x00")
            )

    def test_the_end_comes_between_two_faces(self):
        data = ply_binary(MESH).data
        self.refused("short.ply", data[:-13], at_byte(len(data) - 13, "the file ends after 39 of 40 instances of element 'face'"))
        data = ply_ascii(MESH).data
        lines = data.splitlines(keepends=True)
        says = PLACE + "the file ends after 39 of 40 instances of element 'face'"
        self.refused("short.ply", b"".join(lines[:-1]), says)
        lines = off(MESH).data.splitlines(keepends=True)
        self.refused("short.off", b"".join(lines[:-1]), PLACE + "the file ends after 39 of 40 faces")

    def test_the_end_comes_where_a_word_should_stand(self):
        data = stl_ascii(MESH).data
        for word in ("normal", "outer", "vertex", "endloop", "endfacet"):
            before = data[: data.index(word.encode("ascii"))]
            self.refused("short.stl", before, PLACE + f"the file ends where '{word}' should stand")

    def test_the_end_comes_within_what_follows_a_list(self):
        for order in "<>":
            data = ply_bytes_with(order, lambda i: [i], lambda i: [0.25])
            self.refused("short.ply", data[:-1], at_byte(len(data) - 2, "the file ends too early"))
            data = ply_bytes_with(order, lambda i: [i], lambda i: [])
            self.refused("short.ply", data[:-5], at_byte(len(data) - 6, "the file ends too early"))

    def test_the_end_of_a_page_of_memory_is_the_end(self):
        """Whoever looks one byte further may be ended by SIGSEGV: the file fills its pages, and no zeros follow it."""
        page = os.sysconf("SC_PAGE_SIZE")
        for file, data, end, says in (
            ("page.obj", obj(MESH).data, b"\nf 1 2 \\", r"'\\' for a vertex index is not an integer"),
            ("page.obj", obj(MESH).data, b"\nf 1 2 +", r"'\+' for a vertex index is not an integer"),
            ("page.obj", obj(MESH).data, b"\nf 1 2 3/", "'' for a texture index is not an integer"),
            ("page.off", off(MESH).data.rpartition(b"\n3")[0], b"\n3 0 5 +", r"'\+' for a vertex index is not a number"),
            ("page.off", off(MESH).data.rpartition(b"\n3")[0], b"\n3 0 5", "a vertex index is missing"),
            ("page.ply", ply_ascii(MESH).data.rpartition(b"\n3")[0], b"\n3 0 5", "list 'vertex_indices' cannot have 3 values"),
            ("page.ply", b"ply\nformat ascii 1.0\ncomment ", b"\nend_header", "the header has no element 'vertex'"),
            ("page.ply", b"ply\nformat ascii 1.0\ncomment ", b"\nelement", "a name is missing"),
            ("page.stl", stl_ascii(MESH).data.removesuffix(b"endsolid"), b"\nfacet normal 0 0", "z is missing"),
            ("page.stl", stl_ascii(MESH).data.removesuffix(b"endsolid"), b"\nends", "'ends' stands where"),
        ):
            if b"comment" in data:
                padding = b"x" * (-(len(data) + len(end)) % page)
            else:
                padding = b" " * (-(len(data) + len(end)) % page)
            whole = data + padding + end
            self.assertEqual(len(whole) % page, 0)
            self.refused(file, whole, PLACE + says)

    def test_the_ply_header_is_wrong(self):
        data = ply_ascii(MESH).data
        for old, new, says in (
            (b"ply\n", b"PLY\n", at_line(1, "a PLY file starts with a line 'ply'")),
            (b"ply\n", b"plyx\n", at_line(1, "a PLY file starts")),
            (b"ply\n", b"", at_line(1, "a PLY file starts")),
            (b"ply\n", b"ply 1.0\n", at_line(1, "unexpected '1.0'")),
            (b"format ascii 1.0\n", b"", PLACE + "the header names no format"),
            (b"format ascii 1.0\n", b"format ascii 1.0\nformat ascii 1.0\n", at_line(3, "the format is named twice")),
            (b"ascii 1.0", b"ascii 2.0", at_line(2, "the format version is not 1.0")),
            (b"ascii 1.0", b"ascii", at_line(2, "the format version is not 1.0")),
            (b"ascii 1.0", b"ASCII 1.0", at_line(2, "unknown format 'ASCII'")),
            (b"ascii 1.0", b"binary 1.0", at_line(2, "unknown format 'binary'")),
            (b"ascii 1.0", b"ascii 1.0 x", at_line(2, "unexpected 'x' at the end of the line")),
            (b"element vertex 22", b"element vertex", at_line(3, "the count is missing")),
            (b"element vertex 22", b"element", at_line(3, "a name is missing")),
            (b"element vertex 22", b"element vertex 22 22", at_line(3, "unexpected '22'")),
            (b"element vertex 22", b"elements vertex 22", at_line(3, "unknown header line 'elements'")),
            (b"element vertex 22\n", b"", at_line(3, "a property comes before the first element")),
            (b"element vertex 22", b"element vertices 22", PLACE + "the header has no element 'vertex'"),
            (b"element face 40", b"element faces 40", r"\Ano faces\Z"),
            (b"property float x", b"property float", at_line(4, "a name is missing")),
            (b"property float x", b"property real x", at_line(4, "unknown type 'real'")),
            (b"property float x", b"property x", at_line(4, "unknown type 'x'")),
            (b"property float x", b"property", at_line(4, "unknown type ''")),
            (b"property float x", b"property float x y", at_line(4, "unexpected 'y'")),
            (b"property float x", b"property float w", PLACE + "element 'vertex' has no property 'x'"),
            (b"property float y", b"property float w", PLACE + "element 'vertex' has no property 'y'"),
            (b"property float z", b"property float w", PLACE + "element 'vertex' has no property 'z'"),
            (b"property float y", b"property float x", PLACE + "property 'x' of element 'vertex' is declared twice"),
            (
                b"property float x",
                b"property list uchar float x",
                PLACE + "property 'x' of element 'vertex' is of the wrong kind",
            ),
            (
                b"list uchar int vertex_indices",
                b"int vertex_indices",
                PLACE + "property 'vertex_indices' .* is of the wrong kind",
            ),
            (b"vertex_indices", b"vertex_numbers", PLACE + "element 'face' has no list 'vertex_indices'"),
            (b"list uchar int", b"list float int", at_line(8, "the length of a list is not an integer")),
            (b"list uchar int", b"list uchar", at_line(8, "unknown type 'vertex_indices'")),
            (b"list uchar int", b"list", at_line(8, "unknown type 'vertex_indices'")),
            (b"list uchar int", b"list uchar float", PLACE + "the vertex indices are not integers"),
            (
                b"uchar int vertex_indices",
                b"uchar int vertex_indices\nproperty list uchar int vertex_index",
                PLACE + ".* is declared twice",
            ),
            (b"end_header", b"end_header x", at_line(9, "unexpected 'x'")),
            (b"end_header", b"end_heade", at_line(9, "unknown header line 'end_heade'")),
            (b"end_header\n", b"", at_line(9, "unknown header line '0.0'")),
            (
                b"element face",
                b"element vertex 0\nproperty float x\nproperty float y\nproperty float z\nelement face",
                PLACE + "element 'vertex' is declared twice",
            ),
            (
                b"end_header",
                b"element face 0\nproperty list uchar int vertex_indices\nend_header",
                PLACE + "element 'face' is declared twice",
            ),
        ):  # fmt: skip
            self.refused("header.ply", changed(data, old, new), says, 4 if "no faces" in says else 3)

    def test_a_line_of_ply_is_split_or_joined(self):
        data = ply_ascii(MESH).data
        self.refused("lines.ply", changed(data, b"\n0.0 0.0 1.0\n", b"\n0.0 0.0\n1.0\n"), at_line(10, "z is missing"))
        self.refused("lines.ply", changed(data, b"\n0.0 0.0 1.0\n", b"\n0.0 0.0 1.0 "), at_line(10, "unexpected '0.5'"))
        self.refused("lines.ply", changed(data, b"\n3 0 5 1\n", b"\n3 0\n5 1\n"), PLACE)

    def test_the_off_header_is_wrong(self):
        data = off(MESH).data
        for new, says in (
            (b"off\n", at_line(1, "an OFF file starts with 'OFF', not with 'off'")),
            (b"", at_line(1, "an OFF file starts with 'OFF', not with '22'")),
            (b"4OFF\n", at_line(1, "only OFF of dimension three can be read")),
            (b"nOFF\n3\n", at_line(1, "only OFF of dimension three can be read")),
            (b"4nOFF\n", at_line(1, "only OFF of dimension three can be read")),
            (b"ST4OFF\n", at_line(1, "only OFF of dimension three can be read")),
            (b"OFF BINARY\n", at_line(1, "binary OFF cannot be read")),
            (b"OFFx\n", at_line(1, "'x' for the count of vertices is not a number")),
            (b"NCOFF\n", at_line(1, "an OFF file starts with 'OFF', not with 'NCOFF'")),
        ):
            self.refused("header.off", changed(data, b"OFF\n", new), says)
        self.refused("header.off", b"OFF\n# nothing\n", PLACE + "the counts are missing")
        self.refused("header.off", b"# nothing\n", PLACE + "an OFF file starts with 'OFF', not with ''")

    def test_stl_words_are_wrong(self):
        data = stl_ascii(MESH).data
        for old, new, says in (
            (b"solid small mesh", b"solids", at_line(1, "'solids' stands where 'solid' should stand")),
            (b"facet normal", b"face normal", at_line(2, "'face' stands where 'facet' or 'endsolid' should stand")),
            (b"facet normal", b"facet norm", at_line(2, "'norm' stands where 'normal' should stand")),
            (b"facet normal 0 0 0", b"facet normal 0 0", at_line(2, "z is missing")),
            (b"facet normal 0 0 0", b"facet normal 0 0 x", at_line(2, "'x' for z is not a number")),
            (b"facet normal 0 0 0", b"facet normal 0 0 0 0", at_line(2, "'0' stands where 'outer' should stand")),
            (b"outer loop", b"inner loop", at_line(3, "'inner' stands where 'outer' should stand")),
            (b"outer loop", b"outer", at_line(4, "'vertex' stands where 'loop' should stand")),
            (b"vertex ", b"vertices ", at_line(4, "'vertices' stands where 'vertex' should stand")),
            (b"endloop", b"vertex 0 0 0\nendloop", at_line(7, "'vertex' stands where 'endloop' should stand")),
            (b"endfacet", b"end", at_line(8, "'end' stands where 'endfacet' should stand")),
            (b"endsolid", b"solid", at_line(r"\d+", "'solid' stands where 'facet' or 'endsolid' should stand")),
        ):
            self.refused("words.stl", changed(data, old, new), says)


if __name__ == "__main__":
    unittest.main()
