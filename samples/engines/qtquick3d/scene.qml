// A small animated scene: a textured ground, cubes and spheres, railings, wires and leaves. scene.cpp makes the meshes
// and textures, moves the camera and sets `time`.
import QtQuick
import QtQuick3D

View3D {
    property real time: 0

    // QQuick3DGeometry and QQuick3DTextureData of scene.cpp
    required property Geometry groundMesh
    required property Geometry railingMesh
    required property Geometry wireMesh
    required property Geometry leafMesh
    required property TextureData white
    required property TextureData tiles
    required property TextureData leaf

    id: view
    renderMode: View3D.Offscreen
    renderFormat: ShaderEffectSource.RGBA32F
    camera: eye
    environment: SceneEnvironment {
        backgroundMode: SceneEnvironment.Color
        clearColor: Qt.rgba(0.30, 0.42, 0.62, 1)
        tonemapMode: SceneEnvironment.TonemapModeNone
        antialiasingMode: SceneEnvironment.NoAA
    }

    component Surface: CustomMaterial {
        id: surface
        property vector4d tint: Qt.vector4d(1, 1, 1, 1)
        property vector4d reflectance: Qt.vector4d(0.04, 0.04, 0.04, 0.25) // rgb: at normal incidence, a: alpha squared
        property real cutoff: 0     // 0: opaque
        property real isTwoSided: 0 // 1: the normal faces the eye
        property TextureInput baseColor: TextureInput { texture: image }
        property alias textureData: image.textureData
        property Texture image: Texture {
            id: image
            generateMipmaps: true
            mipFilter: Texture.Linear
        }
        fragmentShader: "material.frag"
    }
    component Moving: Model {
        property int index
        property real phase: view.time + index
        property real angle: index * Math.PI / 3
        position: Qt.vector3d(3 * Math.cos(angle), 0.95 + 0.25 * Math.sin(1.3 * phase), 3 * Math.sin(angle))
        rotation: Quaternion.fromAxisAndAngle(Qt.vector3d(0.2, 1, 0.1).normalized(), 0.7 * phase * 180 / Math.PI)
    }
    component Cube: Moving {
        source: "#Cube" // 100 units wide
        scale: Qt.vector3d(0.01, 0.01, 0.01)
    }
    component Sphere: Moving {
        source: "#Sphere"
        scale: Qt.vector3d(0.012, 0.012, 0.012)
    }

    Surface {
        id: red
        textureData: view.white
        tint: Qt.vector4d(0.60, 0.08, 0.05, 1)
        reflectance: Qt.vector4d(0.04, 0.04, 0.04, 0.1225)
    }
    Surface {
        id: blue
        textureData: view.white
        tint: Qt.vector4d(0.06, 0.12, 0.55, 1)
        reflectance: Qt.vector4d(0.05, 0.05, 0.05, 0.0625)
    }
    Surface {
        id: tiled
        textureData: view.tiles
        tint: Qt.vector4d(1.0, 0.9, 0.7, 1)
        reflectance: Qt.vector4d(0.04, 0.04, 0.04, 0.36)
    }
    Surface {
        id: metal
        textureData: view.white
        tint: Qt.vector4d(0.05, 0.05, 0.05, 1)
        reflectance: Qt.vector4d(0.60, 0.60, 0.60, 0.09)
    }

    CustomCamera {
        id: eye
        objectName: "eye"
    }
    DirectionalLight {
        color: Qt.rgba(1.0, 0.97, 0.93, 1)
        ambientColor: Qt.rgba(0.44, 0.46, 0.51, 1)
        brightness: 2.6
        eulerRotation: Qt.vector3d(-45, 37, 0)
    }
    PointLight {
        position: Qt.vector3d(-4.0, 2.2, -2.5)
        color: Qt.rgba(1.0, 0.77, 0.54, 1)
        brightness: 1.4
        constantFade: 0
        quadraticFade: 1000 // Qt's largest: the inverse-square law with an intensity of 10 times the brightness
    }
    PointLight {
        position: Qt.vector3d(4.0, 1.8, 1.5)
        color: Qt.rgba(0.58, 0.80, 1.0, 1)
        brightness: 0.6
        constantFade: 0
        quadraticFade: 500
    }

    Model {
        geometry: view.groundMesh
        materials: Surface { textureData: view.tiles }
    }
    Cube { index: 0; materials: red }
    Sphere { index: 1; materials: blue }
    Cube { index: 2; materials: tiled }
    Sphere { index: 3; materials: metal }
    Cube { index: 4; materials: red }
    Sphere { index: 5; materials: blue }
    Model {
        geometry: view.railingMesh
        materials: metal
    }
    Model {
        geometry: view.wireMesh
        materials: Surface {
            textureData: view.white
            tint: Qt.vector4d(0.02, 0.02, 0.02, 1)
        }
    }
    Model {
        geometry: view.leafMesh
        rotation: Quaternion.fromAxisAndAngle(Qt.vector3d(0.2, 1, 0.1).normalized(), 0.7 * view.time * 180 / Math.PI)
        materials: Surface {
            textureData: view.leaf
            reflectance: Qt.vector4d(0.03, 0.03, 0.03, 0.36)
            cutoff: 0.5
            isTwoSided: 1
            cullMode: Material.NoCulling
        }
    }
}
