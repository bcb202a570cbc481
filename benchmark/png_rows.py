"""PNG images of 8-bit RGB, which is all that agaa-harness writes, as rows of bytes."""
import struct
import zlib


class ImageError(Exception):
    """One sentence for the user."""


def paeth(left, up, corner):
    estimate = left + up - corner
    distances = abs(estimate - left), abs(estimate - up), abs(estimate - corner)
    return (left, up, corner)[distances.index(min(distances))]


def unfilter(kind, line, above):
    """Undoes the filter of one scanline in place."""
    for i in range(len(line)):
        left, corner = (line[i - 3], above[i - 3]) if i >= 3 else (0, 0)
        up = above[i]
        line[i] = (line[i] + (0, left, up, (left + up) // 2, paeth(left, up, corner))[kind]) & 255
    return line


def read_png(path):
    """Rows of RGB bytes."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", body)
            if (depth, color, interlace) != (8, 2, 0):
                raise ImageError(f"{path} is not an 8-bit RGB image.")
        packed += body if kind == b"IDAT" else b""
        at += length + 12
    raw, rows, stride = zlib.decompress(packed), [bytearray(3 * width)], 3 * width + 1
    for y in range(height):
        line = raw[y * stride:(y + 1) * stride]
        rows.append(unfilter(line[0], bytearray(line[1:]), rows[-1]))
    return rows[1:]


def write_png(path, rows, repeats):
    """Writes each row `repeats` times. Repeated rows are stored as differences, which are 0."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    width = len(rows[0]) // 3
    lines = b"".join(b"\0" + row + (b"\2" + bytes(len(row))) * (repeats - 1) for row in rows)
    header = struct.pack(">IIBBBBB", width, len(rows) * repeats, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines, 9)) +
                     chunk(b"IEND", b""))


def crop(rows, x, y, width, height):
    """A part of an image; x, y, width and height in pixels."""
    return [row[3 * x:3 * (x + width)] for row in rows[y:y + height]]


def enlarge(row, repeats):
    """A row with each pixel `repeats` times."""
    return b"".join(row[i:i + 3] * repeats for i in range(0, len(row), 3))


def beside(panels, repeats, gap):
    """Rows of images of equal height side by side, enlarged along x, with white gaps of `gap` enlarged pixels."""
    white = b"\xff" * (3 * gap)
    return [white.join(enlarge(part, repeats) for part in parts) for parts in zip(*panels)]
