#!/usr/bin/env python3
"""Prints what is in a PNG file, read without any library but zlib: plain_png.py FILE

The kinds of its chunks, `width height bits colour_type`, each text as `KEY=TEXT` with the bytes outside ASCII escaped, and
then all values, as whole numbers on one line.
"""

import struct
import sys
import zlib

CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}


def chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at = 8
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        (check,) = struct.unpack(">I", data[at + 8 + size : at + 12 + size])
        assert check == zlib.crc32(kind + body), kind
        yield kind.decode(), body
        at += 12 + size


def paeth(left, up, corner):
    distances = [abs(left + up - corner - value) for value in (left, up, corner)]
    return (left, up, corner)[distances.index(min(distances))]


def unfiltered(raw, height, row_size, pixel_size):
    rows, above = [], bytes(row_size)
    for y in range(height):
        kind, *row = raw[y * (row_size + 1) : (y + 1) * (row_size + 1)]
        for i in range(row_size):
            left, corner = (row[i - pixel_size], above[i - pixel_size]) if i >= pixel_size else (0, 0)
            guess = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[kind]
            row[i] = (row[i] + guess) & 255
        rows.append(bytes(row))
        above = row
    return rows


def text_of(kind, body):
    key, rest = body.split(b"\0", 1)
    text = rest.decode("latin-1") if kind == "tEXt" else rest.split(b"\0", 4)[4].decode("utf-8")
    return f"{key.decode('latin-1')}={text.encode('unicode_escape').decode('ascii')}"


def main():
    with open(sys.argv[1], "rb") as file:
        found = list(chunks(file.read()))
    header = next(body for kind, body in found if kind == "IHDR")
    width, height, bits, colour_type, *rest = struct.unpack(">IIBBBBB", header)
    assert rest == [0, 0, 0], rest
    print(" ".join(kind for i, (kind, _) in enumerate(found) if i == 0 or kind != found[i - 1][0]))
    print(width, height, bits, colour_type)
    for kind, body in found:
        if kind in ("tEXt", "iTXt"):
            print(text_of(kind, body))
    pixel_size = CHANNELS[colour_type] * bits // 8
    raw = zlib.decompress(b"".join(body for kind, body in found if kind == "IDAT"))
    assert len(raw) == height * (width * pixel_size + 1)
    rows = b"".join(unfiltered(raw, height, width * pixel_size, pixel_size))
    print(*struct.unpack(f">{len(rows) * 8 // bits}{'B' if bits == 8 else 'H'}", rows))


main()
