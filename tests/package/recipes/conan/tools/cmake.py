"""CMake's steps. A recipe of the tests has configure_options, the options that a profile would give."""
import os
import subprocess


def cmake_layout(recipe):
    os.makedirs(recipe.build_folder, exist_ok=True)


class CMakeDeps:
    def __init__(self, recipe):
        pass

    def generate(self):
        pass  # the packages are those of Debian


class CMakeToolchain:
    def __init__(self, recipe):
        self.recipe, self.variables = recipe, {}

    def generate(self):
        self.recipe.toolchain = [f"-D{name}={'ON' if value is True else 'OFF' if value is False else value}"
                                 for name, value in self.variables.items()]


class CMake:
    def __init__(self, recipe):
        self.recipe = recipe

    def _run(self, *arguments):
        result = subprocess.run([os.environ["AGAA_CMAKE"], *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if result.returncode:
            raise AssertionError(result.stdout)

    def configure(self):
        self._run("-S", self.recipe.source_folder, "-B", self.recipe.build_folder, *self.recipe.toolchain,
                  *self.recipe.configure_options)

    def build(self):
        self._run("--build", self.recipe.build_folder)

    def install(self):
        self._run("--install", self.recipe.build_folder, "--prefix", self.recipe.package_folder)
