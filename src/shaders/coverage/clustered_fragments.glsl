// The fragments of a pixel that are clustered, as samples. Needs coverage/shown_fragments.glsl and
// aggregate/pixel_samples.glsl.
#ifndef AGAA_CLUSTERED_FRAGMENTS_GLSL
#define AGAA_CLUSTERED_FRAGMENTS_GLSL
#if !defined(AGAA_SHOWN_FRAGMENTS_GLSL) || !defined(AGAA_PIXEL_SAMPLES_GLSL)
#error "clustered_fragments.glsl needs shown_fragments.glsl and pixel_samples.glsl."
#endif

const uint agaa_maxClustered = 32u;

// The aggregate of a fragment. Before fragments are grouped, it is the fragment's number among those that are
// clustered, or agaa_maxClustered.
#define AGAA_AGGREGATE_OF_FRAGMENT (AGAA_PAYLOAD_AT + AGAA_KEPT_PLANE_WORDS)
void agaa_setAggregate(uint record, uint a) { agaa_fragments.words[record + AGAA_AGGREGATE_OF_FRAGMENT] = a; }
uint agaa_aggregateOf(uint record) { return agaa_fragments.words[record + AGAA_AGGREGATE_OF_FRAGMENT]; }

// Returns the material at an offset from the pixel's centre. Its normal is that at the pixel's corner.
AgaaMaterial agaa_fetchCovered(AgaaPrimitive p, uvec2 pixel, vec2 middle) {
    agaa_evaluateAt(p, pixel, middle + 0.5);
    AgaaMaterial m = agaa_evaluateMaterial(p);
    m.normal -= (middle.x + 0.5) * m.normalDx + (middle.y + 0.5) * m.normalDy;
    return m;
}

// A fragment as a sample at the centroid of the samples that show it.
struct agaa_FragmentSample {
    vec3 position; // view space
    float depth;
    vec2 offset; // in the pixel, [0, 1]
    vec3 normal; // of its plane
    uint code;   // of agaa_codeWithClass()
    // The following members are set with AGAA_GLOSS_WEIGHT.
    vec3 shadingNormal;
    float alpha2;
};

float agaa_fragmentQuantum(float depth) { return 2.4e-7 * depth; }

agaa_FragmentSample agaa_sampleOfFragment(uvec2 pixel, uint record) {
    agaa_FragmentSample s;
    vec2 middle = agaa_coverageMiddle(agaa_maskOf(record), AGAA_SAMPLES);
    s.depth = agaa_deviceDepth(agaa_depthAt(agaa_keptPlane(record), middle));
    s.offset = middle + 0.5;
    s.position = agaa_viewPositionAt(pixel, s.offset, s.depth);
    AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
    s.normal = agaa_planeNormal(p);
    s.shadingNormal = s.normal;
    s.alpha2 = 1.0;
    uint class_ = 0u;
    if (AGAA_GLOSS_WEIGHT != 0u || AGAA_CLASSES) {
        AgaaMaterial m = agaa_fetchCovered(p, pixel, middle);
        vec3 n = m.normal + s.offset.x * m.normalDx + s.offset.y * m.normalDy;
        s.shadingNormal = n * inversesqrt(max(dot(n, n), 1e-6));
        s.alpha2 = m.alpha2;
        class_ = agaa_classOfMaterial(m);
    }
    s.code = agaa_codeWithClass(agaa_codeOfNormal(s.normal), class_, agaa_coverageCount(agaa_maskOf(record)));
    return s;
}

uint agaa_countShown(uint head, uint least) {
    uint count = 0u;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        count += agaa_coverageCount(agaa_maskOf(record)) >= least ? 1u : 0u;
        fragment = agaa_nextOf(record);
    }
    return count;
}

// The seed that is nearest to a fragment which was not clustered. A seed of the fragment's class comes before others.
struct agaa_NearestSeed {
    uint aggregate;
    bool hasOtherClass;
    float distance;
};

agaa_NearestSeed agaa_noSeed() { return agaa_NearestSeed(0u, true, 3.0e38); }

void agaa_compareSeed(inout agaa_NearestSeed nearest, uint a, float distance, uint keyB, uint keyBOfSeed) {
    bool hasOtherClass = AGAA_CLASSES && agaa_classOfKey(keyB) != agaa_classOfKey(keyBOfSeed);
    bool isNearer = hasOtherClass == nearest.hasOtherClass ? distance < nearest.distance : !hasOtherClass;
    if (isNearer)
        nearest = agaa_NearestSeed(a, hasOtherClass, distance);
}

// Returns the aggregate of the seed, and counts the fragment if that has another class.
uint agaa_countedSeed(agaa_NearestSeed nearest) {
    agaa_count(AGAA_COUNT_JOINED_CLASSES, nearest.hasOtherClass ? 1u : 0u);
    return nearest.aggregate;
}

// Returns whether the fragments of a pixel may be in several aggregates.
// shown   Number of fragments that show at a sample.
bool agaa_groupsFragments(uint shown) { return shown > 1u && AGAA_AGGREGATES > 1u; }

// Puts all fragments of a list in the first aggregate.
void agaa_joinFragments(uint head) {
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        agaa_setAggregate(record, 0u);
        fragment = agaa_nextOf(record);
    }
}

// The includer defines this function, which receives each fragment that is clustered.
void agaa_takeFragment(uvec2 pixel, uint item, uint fragment);

// Chooses up to agaa_maxClustered fragments, those with the most visible samples. Among fragments with equally many, it
// takes evenly spaced ones, so that near and far ones are represented. Returns their number.
uint agaa_chooseLargest(uvec2 pixel, uint head, uint shown) {
    // All fragments with this number of samples have room: at most 32 fragments have 4 of 128 samples.
    uint enough = 1u;
    uint smaller = 0u; // fragments that show at one sample less
    while (enough < 4u && shown > agaa_maxClustered) {
        ++enough;
        smaller = shown;
        shown = agaa_countShown(head, enough);
        smaller -= shown;
    }
    uint room = agaa_maxClustered - shown; // for smaller fragments
    uint passed = 0u;
    uint count = 0u;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uint bits = agaa_coverageCount(agaa_maskOf(record));
        bool isSmaller = bits + 1u == enough && bits != 0u;
        bool isTaken = isSmaller && (passed + 1u) * room / smaller > passed * room / smaller;
        passed += isSmaller ? 1u : 0u;
        if ((bits >= enough || isTaken) && count < agaa_maxClustered) {
            agaa_takeFragment(pixel, count, fragment);
            agaa_setAggregate(record, count);
            ++count;
        } else {
            agaa_setAggregate(record, agaa_maxClustered);
        }
        fragment = agaa_nextOf(record);
    }
    return count;
}
#endif
