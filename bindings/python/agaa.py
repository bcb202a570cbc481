"""The AGAA SDK from Python: ctypes classes and functions, generated from the description agaa.json of the C ABI.

    sdk = agaa.Library("libagaa.so.0.2")
    config = sdk.new("AgaaConfig")       # initialised with the defaults
    config.samples = 32
    sdk.call("agaaQueryMemory", ...)     # raises agaa.Error if the result is below 0

Structs, callbacks and constants are attributes of the library with their names in C: sdk.AgaaConfig,
sdk.AGAA_CONFIG_COUNTERS. docs/integration/ and the headers describe them.
"""
import ctypes
import json
import pathlib

SCALARS = {"char": ctypes.c_char, "int": ctypes.c_int, "float": ctypes.c_float, "double": ctypes.c_double,
           "uint32_t": ctypes.c_uint32, "int32_t": ctypes.c_int32, "uint64_t": ctypes.c_uint64,
           "int64_t": ctypes.c_int64, "size_t": ctypes.c_size_t, "AgaaResult": ctypes.c_int32, "void": None}


class Error(Exception):
    def __init__(self, function, name, description):
        super().__init__(f"{function}: {name}, {description}")
        self.name = name


def description_file():
    """Returns agaa.json: next to this file in an installation, else in abi/ of the sources."""
    here = pathlib.Path(__file__).resolve().parent
    beside = here / "agaa.json"
    return beside if beside.exists() else here.parents[1] / "abi" / "agaa.json"


class Library:
    def __init__(self, path, description=None):
        self._library = ctypes.CDLL(path)
        self._types = dict(SCALARS)
        self._functions = {}
        text = pathlib.Path(description or description_file()).read_text()
        self._make(json.loads(text))

    def _type(self, name):
        """Returns the ctypes type of a C type. It ignores const."""
        name = name.replace("const ", "").replace(" const", "").strip()
        if name in ("char*", "void*"):
            return ctypes.c_char_p if name == "char*" else ctypes.c_void_p
        if name.endswith("[]"):
            return ctypes.POINTER(self._type(name[:-2]))
        if name.endswith("*"):
            target = self._type(name[:-1])
            return ctypes.c_void_p if target is None else ctypes.POINTER(target)
        return self._types[name]

    def _field(self, member):
        kind = self._type(member["type"])
        for length in reversed(member.get("lengths", [])):
            kind = kind * length
        return member["name"], kind

    def _make(self, description):
        for name in description["handles"]:
            self._types[name] = ctypes.c_void_p
        for enum, values in description["enums"].items():
            self._types[enum] = ctypes.c_uint32
            for name, value in values.items():
                setattr(self, name, value)
        for name, value in description["constants"].items():
            setattr(self, name, value)
        # Structs point to each other and to callbacks, so all types are declared before their members.
        for name in description["structs"]:
            self._types[name] = type(name, (ctypes.Structure,), {})
        for name, callback in description["callbacks"].items():
            self._types[name] = None
        for name, callback in description["callbacks"].items():
            self._types[name] = self._callback(callback)
        for name, struct in description["structs"].items():
            self._types[name]._fields_ = [self._field(member) for member in struct["members"]]
            assert ctypes.sizeof(self._types[name]) == struct["size"], name
        for name in [*description["structs"], *description["callbacks"]]:
            setattr(self, name, self._types[name])
        for function in description["functions"]:
            self._functions[function["name"]] = self._function(function)

    def _callback(self, callback):
        parameters = [self._type(parameter["type"]) for parameter in callback["parameters"]]
        returned = self._type(callback["returns"])
        if returned is None and callback["returns"] != "void":
            returned = ctypes.c_void_p  # the type is a callback that is declared later
        return ctypes.CFUNCTYPE(returned, *parameters)

    def _function(self, function):
        found = getattr(self._library, function["name"])
        found.argtypes = [self._type(parameter["type"]) for parameter in function["parameters"]]
        found.restype = self._type(function["returns"])
        found.isResult = function["returns"] == "AgaaResult"
        return found

    def new(self, struct):
        """Returns a struct with its defaults."""
        value = self._types[struct]()
        sizes = [ctypes.sizeof(value)] if len(self._functions["agaaInit" + struct[4:]].argtypes) > 1 else []
        self._functions["agaaInit" + struct[4:]](ctypes.byref(value), *sizes)
        return value

    def array(self, struct, count):
        """Returns an array of structs with their defaults."""
        return (self._types[struct] * count)(*[self.new(struct) for _ in range(count)])

    def call(self, function, *arguments):
        found = self._functions[function]
        result = found(*arguments)
        if found.isResult and result < 0:
            raise Error(function, self.call("agaaResultName", result).decode(),
                        self.call("agaaResultString", result).decode())
        return result
