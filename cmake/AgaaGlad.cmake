# The OpenGL loader: one table per context, generated offline by Debian's glad. Target agaa_glad, header
# <glad/gl.h>, whose GladGLContext holds the functions.
if(AGAA_GENERATED)
  set(glad_folder ${AGAA_GENERATED}/glad)
else()
  find_program(GLAD glad REQUIRED)
  set(glad_folder ${PROJECT_BINARY_DIR}/glad)
endif()
# These extensions have functions that OpenGL 4.3 lacks, so contexts below 4.5 load them too, or they are optional.
set(glad_extensions GL_ARB_direct_state_access GL_ARB_buffer_storage GL_ARB_clip_control GL_KHR_debug
    GL_ARB_post_depth_coverage GL_ARB_texture_filter_anisotropic GL_EXT_texture_filter_anisotropic
    GL_NV_framebuffer_mixed_samples GL_NV_sample_mask_override_coverage GL_ARB_polygon_offset_clamp
    GL_EXT_polygon_offset_clamp GL_ARB_query_buffer_object GL_AMD_depth_clamp_separate
    GL_NV_internalformat_sample_query GL_ARB_fragment_shader_interlock
    GL_EXT_shader_framebuffer_fetch GL_KHR_robustness GL_KHR_shader_subgroup GL_ARB_sample_locations
    GL_NV_viewport_array2)
list(JOIN glad_extensions "," glad_extensions)
if(NOT AGAA_GENERATED)
  add_custom_command(
    OUTPUT ${glad_folder}/src/gl.c ${glad_folder}/include/glad/gl.h
    COMMAND ${GLAD} --quiet --reproducible --api gl:compatibility=4.6 --extensions ${glad_extensions}
            --out-path ${glad_folder} c --mx
    COMMENT "Generating the OpenGL loader" VERBATIM)
endif()
add_library(agaa_glad STATIC ${glad_folder}/src/gl.c ${glad_folder}/include/glad/gl.h)
target_include_directories(agaa_glad SYSTEM PUBLIC ${glad_folder}/include)
# Engines that link the static library may have a loader of their own with the same function names and other tables.
target_compile_definitions(agaa_glad PUBLIC gladLoadGLContext=agaa_gladLoadGLContext
                                            gladLoadGLContextUserPtr=agaa_gladLoadGLContextUserPtr)
target_compile_options(agaa_glad PRIVATE -w)
