// The bounding box of the positions at which a list's fragments, or aggregates of them, are shaded. Needs
// common/tile_lights.glsl, coverage/list_visibility.glsl and coverage/surface_position.glsl.
#ifndef AGAA_LIST_BOX_GLSL
#define AGAA_LIST_BOX_GLSL
#if !defined(AGAA_TILE_LIGHTS_GLSL) || !defined(AGAA_LIST_VISIBILITY_GLSL) || !defined(AGAA_SURFACE_POSITION_GLSL)
#error "list_box.glsl needs tile_lights.glsl, list_visibility.glsl and surface_position.glsl."
#endif

// head: of a list that agaa_resolveList() has resolved.
agaa_Box agaa_boxOfList(uvec2 pixel, uint head) {
    agaa_Box box = agaa_emptyBox();
    for (uint fragment = agaa_needsTileBox() ? head : 0u; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uvec4 mask = agaa_maskOf(record);
        if (agaa_coverageCount(mask) != 0u) // a list of one may have none: it is at the far plane
            agaa_addToBox(box,
                          agaa_viewPositionOf(pixel, agaa_keptPlane(record), agaa_coverageMiddle(mask, AGAA_SAMPLES)));
        fragment = agaa_nextOf(record);
    }
    return box;
}
#endif
