/* A small animated scene, made in code: a textured ground, cubes and spheres, railings, wires and leaves.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include <Ogre.h>

#include <vector>

class Scene {
public:
    explicit Scene(Ogre::Root& root);
    void setTime(float seconds); // moves the objects and the camera

    Ogre::SceneManager& manager() { return *m_manager; }
    Ogre::Camera& camera() { return *m_camera; }
    static Ogre::ColourValue background() { return Ogre::ColourValue(0.30f, 0.42f, 0.62f); } // linear

private:
    void createMaterials();
    void createGround();
    void createObjects();
    void createRailings();
    void createLeaves();
    void createLights();
    Ogre::SceneNode* addPrefab(Ogre::SceneManager::PrefabType type, const char* material, Ogre::Vector3 position,
                               float size);

    Ogre::SceneManager* m_manager;
    Ogre::Camera* m_camera;
    Ogre::SceneNode* m_cameraNode;
    std::vector<Ogre::SceneNode*> m_moving;
};
