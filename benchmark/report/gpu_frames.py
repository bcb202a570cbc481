"""Frames of a GPU from the results of benchmark/gpu_run.py (passes.json)."""


def gpu_frames(passes, backend="vk"):
    """The device, the size and the frames of a backend. A frame's time is the sum of its passes. Its way is ""
    where hosts get it by default; presets choose c themselves."""
    rows = [row for row in passes["rows"] if row["backend"] == backend]
    if not rows:
        return None
    return {"device": rows[0]["device"], "size": rows[0]["size"], "backend": backend,
            "frames": [{"scene": row["scene"], "technique": row["technique"], "n": row["samples"], "c": row["aggregates"],
                        "preset": row["preset"], "tier": row["tiers"].get("generation", ""), "way": row["way"],
                        "ms": sum(each["ms"]["median"] for each in row["passes"])} for row in rows]}
