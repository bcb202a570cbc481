"""Frames of a GPU from the results of benchmark/gpu_run.py (passes.json)."""


def gpu_frames(passes):
    """The device, the size and the Vulkan frames of the ways that hosts get by default. A frame's time is the sum of its
    passes; presets choose c themselves."""
    rows = passes["rows"]
    return {"device": rows[0]["device"], "size": rows[0]["size"], "frames": [
        {"scene": row["scene"], "technique": row["technique"], "n": row["samples"], "c": row["aggregates"], "preset": row["preset"],
         "tier": row["tiers"].get("generation", ""), "ms": sum(each["ms"]["median"] for each in row["passes"])}
        for row in rows if row["backend"] == "vk" and not row["way"]]}
