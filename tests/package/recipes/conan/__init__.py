"""The part of Conan 2 that the recipe of the SDK uses, as Conan documents it."""


class ConanFile:
    def __init__(self):
        self.required = []

    def requires(self, reference):
        self.required.append(reference)
