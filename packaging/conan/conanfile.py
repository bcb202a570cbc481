"""A recipe of Conan 2, which builds the release archive that it lies in:

    conan create packaging/conan
"""
import pathlib
import re

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy

FOLDERS = "CMakeLists.txt", "LICENSE", "*.md", "abi/*", "bindings/*", "cmake/*", "docs/*", "generated/*", "include/*", \
    "samples/minimal/*", "src/*"


class AgaaConan(ConanFile):
    name = "agaa"
    description = "Anti-aliasing for deferred shading without history"
    license = "MIT"
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": True}

    @property
    def archive(self):
        return pathlib.Path(self.recipe_folder).resolve().parents[1]

    def set_version(self):
        text = (self.archive / "include" / "agaa" / "base.h").read_text(encoding="utf-8")
        self.version = ".".join(re.search(rf"AGAA_VERSION_{part} (\d+)", text)[1] for part in ("MAJOR", "MINOR", "PATCH"))

    def export_sources(self):
        if not (self.archive / "generated").is_dir():
            raise ConanInvalidConfiguration(f"{self.archive} is no release archive: it has no generated files. "
                                            "scripts/release makes one.")
        for pattern in FOLDERS:
            copy(self, pattern, str(self.archive), self.export_sources_folder)

    def requirements(self):
        self.requires("glslang/1.3.268.0")
        self.requires("vulkan-headers/1.3.268.0")
        self.requires("zstd/1.5.5")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.variables["AGAA_STATIC"] = not self.options.shared
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, str(pathlib.Path(self.package_folder) / "licenses"))

    def package_info(self):
        self.cpp_info.libs = ["agaa"]
        if not self.options.shared:
            self.cpp_info.defines = ["AGAA_STATIC"]
