/* The SDK's framebuffers as a render target of OGRE.
 * SPDX-License-Identifier: MIT
 */
#pragma once

#include "agaa_sdk.h"

#include <OgreDepthBuffer.h>
#include <RenderSystems/GL3Plus/OgreGL3PlusRenderSystem.h>
#include <RenderSystems/GL3Plus/OgreGLRenderTarget.h>
#include <RenderSystems/GL3Plus/OgreGLRenderTexture.h>

// OGRE's header declares the constructor, but Debian's library does not export it.
inline Ogre::GLFrameBufferObjectCommon::GLFrameBufferObjectCommon(int32 fsaa)
    : mContext(nullptr), mFB(0), mMultisampleFB(0), mNumSamples(fsaa) {}

namespace agaaOgre {

class SdkTarget : public Ogre::RenderTarget, public Ogre::GLRenderTarget {
public:
    explicit SdkTarget(Ogre::GL3PlusRenderSystem& renderSystem) : m_framebuffer(renderSystem) {
        mName = "AGAA SDK";
        setDepthBufferPool(Ogre::DepthBuffer::POOL_NO_DEPTH); // the framebuffer has its depth
    }
    void setTarget(const AgaaDrawTarget& target) {
        mWidth = target.width, mHeight = target.height;
        m_framebuffer.name = target.framebuffer;
    }
    bool requiresTextureFlipping() const override { return true; } // as OGRE's render textures: row 0 is the top
    Ogre::GLContext* getContext() const override { return m_framebuffer.renderSystem._getMainContext(); }
    Ogre::GLFrameBufferObjectCommon* getFBO() override { return &m_framebuffer; }
    void copyContentsToMemory(const Ogre::Box&, const Ogre::PixelBox&, FrameBuffer) override {}

private:
    struct Framebuffer : Ogre::GLFrameBufferObjectCommon {
        explicit Framebuffer(Ogre::GL3PlusRenderSystem& system) : GLFrameBufferObjectCommon(0), renderSystem(system) {}
        bool bind(bool) override {
            renderSystem._getStateCacheManager()->bindGLFrameBuffer(GL_FRAMEBUFFER, name);
            return true;
        }
        void initialise() override {}
        Ogre::GL3PlusRenderSystem& renderSystem;
        uint32_t name = 0;
    } m_framebuffer;
};

} // namespace agaaOgre
