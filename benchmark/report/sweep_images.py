"""Selects the images of a sweep for its page, packs them tighter, and includes each only once."""

import base64
import hashlib
import struct
import zlib
from pathlib import PurePosixPath

SIGNATURE = b"\x89PNG\r\n\x1a\n"
JPEG = b"\xff\xd8\xff"
# Readers compare these first.
FIRST_N = [8, 32, 4, 16]
FIRST_TECHNIQUES = ["agaa", "simple_complex", "ssaa", "sbaa", "msaa", "fxaa", "single"]
PAIR = 1  # images up to this rank are taken before those of the next scene


def chunks(png):
    """Yields kind and data of each chunk. Raises ValueError if the bytes are not a complete PNG."""
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
    """The same picture in fewer bytes: the sweep compresses weakly, to save time."""
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
    """The bytes of an image inside the folder, or None if it is missing or cannot be shown."""
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
    """The position of a row's image in the queue: agaa, and its best preset, have 0, its first rival 1."""
    n, c, technique = row.get("n"), row.get("c"), row.get("technique")
    position = FIRST_TECHNIQUES.index(technique) if technique in FIRST_TECHNIQUES else 7
    position += 10 * (FIRST_N.index(n) if n in FIRST_N else 0 if n in (0, 1, None) else 4)
    tiers = row.get("tiers")
    tier = tiers.get("generation") if isinstance(tiers, dict) else None
    if row.get("preset") == "accurate" and tier == "ids":
        return position  # the best preset, compared with the settings of the paper
    if tier in ("gbuffer", "ids") or row.get("preset"):
        position += 50  # looks like the image of two passes, or between both
    return position + (0 if c in (0, 2, None) else 100)


def number(row, key, member):
    found = row.get(key)
    found = found.get(member) if isinstance(found, dict) else None
    return found if isinstance(found, (int, float)) else None


def front(rows):
    """The rows that have less error than all faster ones: the page shows them first."""
    timed = [(number(row, "frameMs", "median"), number(row, "errorReference", "mseTm"), i) for i, row in enumerate(rows)
             if row.get("shadingCost", 1) == 1 and row.get("technique") != "taa"]  # as best.js
    found, least = [], None
    for _, error, i in sorted(entry for entry in timed if None not in entry):
        if least is None or error < least:
            found.append(rows[i])
            least = error
    return found


def dicts(value):
    return [item for item in value if isinstance(item, dict)] if isinstance(value, list) else []


def wanted(results):
    """Position, holder, key and the scene's prefix of file names, for each image that the page may show, in order.

    The images that a reader compares first come first, scene by scene, for the first backend and then for the others,
    whose images are alike: the reference, single and the rows of the Pareto front. The other images follow over all
    scenes.
    """
    found = []
    for which, backend in enumerate(dicts(results.get("backends"))):
        for index, scene in enumerate(dicts(backend.get("scenes"))):
            if scene.get("plain"):  # the page shows no image of it
                continue
            pair = (-1, which, index)
            prefix = f"{backend.get('backend')}-{scene.get('name')}-"
            found.append((pair, scene, "referenceImage", prefix))
            rows = dicts(scene.get("rows"))
            best = front(rows)
            for row in rows:
                in_pair = rank(row) <= PAIR
                is_first = in_pair or row.get("technique") == "single" or any(row is one for one in best)
                found.append((pair if is_first else (rank(row), which, index), row, "image", prefix))
                found.append((pair if in_pair else (rank(row) + 5, which, index), row, "heat", prefix))
                # The page subtracts any two images itself. It needs the written difference only without a reference.
                if scene.get("referenceImage"):
                    row.pop("difference", None)
                else:
                    found.append(((rank(row) + 5, which, index), row, "difference", prefix))
    return sorted(found, key=lambda entry: entry[0])


def is_selected(file, prefix, names):
    return not names or (isinstance(file, str) and PurePosixPath(file).stem.removeprefix(prefix) in names)


def take_images(results, folder, most_bytes, names=()):
    """Replaces file names in the results by ids. Returns the base64 texts of the ids, and how many images are left out.

    names: only these images of each scene, such as "reference" and "agaa-8-2"; empty: all.
    """
    ids, texts, room, left_out = {}, [], most_bytes, 0
    for _, holder, key, prefix in wanted(results):
        name = holder.get(key)
        holder[key] = None
        # If the room is used up, the rest is not read: a whole sweep has gigabytes of images.
        image = read_image(folder, name) if room > 0 and is_selected(name, prefix, names) else None
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
