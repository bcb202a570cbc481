"""Which of a sweep's images go into its page, packed tighter and each only once."""

import base64
import hashlib
import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"
JPEG = b"\xff\xd8\xff"
# What a reader compares first; everything else follows.
FIRST_N = [8, 32, 4, 16]
FIRST_TECHNIQUES = ["agaa", "simple_complex", "ssaa", "sbaa", "msaa", "fxaa", "single"]
PAIR = 1  # up to this rank a scene's images are taken before those of the next scene


def chunks(png):
    """(kind, data) of each chunk; raises ValueError where the bytes are no whole PNG."""
    if not png.startswith(SIGNATURE):
        raise ValueError("no PNG")
    at = len(SIGNATURE)
    while at < len(png):
        if at + 12 > len(png):
            raise ValueError("PNG ends early")
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        if at + 12 + length > len(png):
            raise ValueError("PNG ends early")
        yield kind, png[at + 8:at + 8 + length]
        at += 12 + length


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def repack(png):
    """The same picture in fewer bytes: writers of images that are in a hurry compress weakly."""
    parts = list(chunks(png))
    scanlines = zlib.decompress(b"".join(data for kind, data in parts if kind == b"IDAT"))
    out, written = [SIGNATURE], False
    for kind, data in parts:
        if kind != b"IDAT":
            out.append(chunk(kind, data))
        elif not written:
            out.append(chunk(b"IDAT", zlib.compress(scanlines, 9)))
            written = True
    packed = b"".join(out)
    return packed if len(packed) < len(png) else png


def read_image(folder, name):
    """Bytes of an image inside the folder, or None where there is none that can be shown."""
    if not isinstance(name, str) or not name:
        return None
    try:
        path = (folder / name).resolve()
        path.relative_to(folder.resolve())
        data = path.read_bytes()
        return data if data.startswith(JPEG) else repack(data)
    except (OSError, ValueError, zlib.error):
        return None


def rank(row):
    """Place of a row's image in the queue for the page's room: agaa, and its best preset, are 0, its first rival 1."""
    n, c, technique = row.get("n"), row.get("c"), row.get("technique")
    place = FIRST_TECHNIQUES.index(technique) if technique in FIRST_TECHNIQUES else 7
    place += 10 * (FIRST_N.index(n) if n in FIRST_N else 0 if n in (0, 1, None) else 4)
    tiers = row.get("tiers")
    tier = tiers.get("generation") if isinstance(tiers, dict) else None
    if row.get("preset") == "accurate" and tier == "ids":
        return place  # the best beside the paper's
    if tier in ("gbuffer", "ids") or row.get("preset"):
        place += 50  # looks as with two passes, or between the two
    return place + (0 if c in (0, 2, None) else 100)


def dicts(value):
    return [item for item in value if isinstance(item, dict)] if isinstance(value, list) else []


def wanted(results):
    """(place, holder, key) of every image that the page may show, the most wanted first: what a reader
    compares first, scene by scene, of the backend that comes first, whose like the others draw; then of these; then
    the rest over all scenes."""
    found = []
    for which, backend in enumerate(dicts(results.get("backends"))):
        for index, scene in enumerate(dicts(backend.get("scenes"))):
            if scene.get("plain"):  # which shows no image
                continue
            pair = (-1, which, index)
            found.append((pair, scene, "referenceImage"))
            for row in dicts(scene.get("rows")):
                in_pair = rank(row) <= PAIR
                found.append((pair if in_pair else (rank(row), which, index), row, "image"))
                found.append((pair if in_pair else (rank(row) + 5, which, index), row, "heat"))
                # The page subtracts any two images itself; it needs the written difference only
                # where it has no reference to subtract.
                if scene.get("referenceImage"):
                    row.pop("difference", None)
                else:
                    found.append(((rank(row) + 5, which, index), row, "difference"))
    return sorted(found, key=lambda entry: entry[0])


def take_images(results, folder, most_bytes):
    """Puts ids in the place of file names; returns the ids' base64 texts and what was left out."""
    ids, texts, room, left_out = {}, [], most_bytes, 0
    for _, holder, key in wanted(results):
        name = holder.get(key)
        holder[key] = None
        # Once the room is used up the rest, some gigabytes of a whole sweep, is not even read.
        image = read_image(folder, name) if room > 0 else None
        if image is None:
            left_out += isinstance(name, str)
            continue
        digest = hashlib.sha256(image).digest()
        if digest not in ids:
            text = base64.b64encode(image).decode("ascii")
            if len(text) > room:
                left_out += 1
                room = 0
                continue
            room -= len(text)
            ids[digest] = len(texts)
            texts.append(text)
        holder[key] = ids[digest]
    return texts, left_out
