// The list of the primitives of a workgroup, in shared memory. Ids, lanes and planes of its entries are needed until
// samples are grouped. With one lane per sample, shading events then use the same words: include the file before
// common/events.glsl, which needs AGAA_MAX_EVENTS. Needs AGAA_HOST_FETCH and common/target.glsl.
#ifndef AGAA_PRIMITIVE_LIST_GLSL
#define AGAA_PRIMITIVE_LIST_GLSL
#if !defined(AGAA_TARGET_GLSL) || !defined(AGAA_HOST_FETCH)
#error "primitive_list.glsl needs target.glsl and AGAA_HOST_FETCH."
#endif

// Capacity of the list. A workgroup with more primitives needs several iterations, each with one pixel at least.
#ifndef AGAA_LIST_LENGTH
#define AGAA_LIST_LENGTH 256u
#endif
const uint agaa_listLength = AGAA_LIST_LENGTH;
shared uint agaa_listedCount; // requested entries; may exceed the capacity
shared uint agaa_listSamples[agaa_listLength]; // 0: unused entry
shared AgaaMaterial agaa_listMaterial[agaa_listLength]; // with the normal at the pixel's corner, not unit
shared uint agaa_pixelList[64]; // first entry | number of entries << 16 | number of aggregates << 24

const uint agaa_groupingWordCount = 5u * agaa_listLength + 64u;
#if AGAA_SAMPLE_LANES && defined(AGAA_MAX_EVENTS)
const uint agaa_eventWordCount = 32u * AGAA_MAX_EVENTS + 192u;
shared uint agaa_listWords[agaa_groupingWordCount > agaa_eventWordCount ? agaa_groupingWordCount : agaa_eventWordCount];
#define AGAA_EVENT_WORD(word) agaa_listWords[word]
#else
shared uint agaa_listWords[agaa_groupingWordCount];
#endif

// The id of an entry, and the lane of its pixel.
#define AGAA_LIST_ID(at) agaa_listWords[at]
#define AGAA_LIST_LANE(at) agaa_listWords[agaa_listLength + (at)]
// Lanes of pixels whose samples are grouped, [0, 63].
#define AGAA_COMPLEX_LANE(index) agaa_listWords[5u * agaa_listLength + (index)]

// The normal of an entry's plane in view space.
vec3 agaa_listedPlane(uint at) {
    const uint first = 2u * agaa_listLength + at;
    return uintBitsToFloat(uvec3(agaa_listWords[first], agaa_listWords[first + agaa_listLength],
                                 agaa_listWords[first + 2u * agaa_listLength]));
}
void agaa_listPlane(uint at, vec3 normal) {
    const uint first = 2u * agaa_listLength + at;
    agaa_listWords[first] = floatBitsToUint(normal.x);
    agaa_listWords[first + agaa_listLength] = floatBitsToUint(normal.y);
    agaa_listWords[first + 2u * agaa_listLength] = floatBitsToUint(normal.z);
}

// Returns the entries of a lane's pixel: the first one and the one after the last.
uvec2 agaa_entriesOf(uint lane) {
    const uint list = agaa_pixelList[lane];
    return (list & 0xFFFFu) + uvec2(0u, list >> 16u & 0xFFu);
}

// The number of aggregates of a lane's pixel.
uint agaa_aggregatesOf(uint lane) { return agaa_pixelList[lane] >> 24u; }
void agaa_setAggregates(uint lane, uint count) {
    agaa_pixelList[lane] = agaa_pixelList[lane] & 0xFFFFFFu | count << 24u;
}
#endif
