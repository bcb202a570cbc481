// Merges the fragments of a pixel into a few surfaces, in the order of their insertion. A surface has a coverage mask,
// one depth plane and one normal.
// Source: Wang et al., "Decoupled Coverage Anti-Aliasing", I3D 2016, sections 3.2 and 3.3, algorithm 1; for the cost of
// merging, Ward 1963, "Hierarchical Grouping to Optimize an Objective Function".
//
// The surfaces are global; in C++ they are members of a struct. The caller has the attributes of surfaces and applies
// the merges that agaa_insertSurface() returns to them. With AGAA_SHARED_SURFACES, coverage/shared_surfaces.glsl has
// agaa_keep() and agaa_keptAt().
#ifndef AGAA_MATH_SURFACE_MERGE_GLSL
#define AGAA_MATH_SURFACE_MERGE_GLSL
#include "coverage_pattern.glsl"
#include "facet_normal.glsl"
#include "real.glsl"

#ifndef AGAA_SHARED_SURFACES
#define AGAA_SHARED_SURFACES 0
#endif
#define AGAA_MAX_KEPT 8u
#define AGAA_NO_SURFACE 0xFFFFFFFFu

// Depths increase away from the eye.
struct agaa_CoveredSurface {
    uvec4 mask;
    rvec3 plane;  // depth at the pixel's centre, and its change per pixel in x and in y
    // A depth in the range, and the distances of the lowest and the highest depth from it: edge-on planes extrapolate
    // without bound.
    rvec3 depths;
    rvec3 normal; // unit
};

// Merge rules, the values of AgaaMerge. VISIBLE counts the samples that show a surface. At first a fragment merges only
// with a surface that shares no sample with it, because two fragments of one continuous surface share none. In a full
// pixel the cheapest pair merges, and no sample that shows a surface is lost. PAPER is algorithm 1, which compares
// facet normals (section 3.4). NONE is PAPER without its second merge. COLOR is VISIBLE with the difference of colours
// in the cost of a merge (section 5.3 proposes to know materials).
#define AGAA_RULE_VISIBLE 0u
#define AGAA_RULE_PAPER 1u
#define AGAA_RULE_NONE 2u
#define AGAA_RULE_COLOR 3u

// The includer may have colours: AGAA_COLOR_DIFFERENCE(i, k) of two surfaces, [0, 1], real.
#ifndef AGAA_COLOR_DIFFERENCE
#define AGAA_COLOR_DIFFERENCE(i, k) real(0.0)
#endif

bool agaa_countsShown(uint rule) {
    return rule == AGAA_RULE_VISIBLE || rule == AGAA_RULE_COLOR;
}

struct agaa_MergeRules {
    uint limit;  // maximum number of surfaces, [1, AGAA_MAX_KEPT]
    real cosine; // lowest cosine between normals that merge
    real slack;  // distance up to which depths overlap
    uint rule;
    agaa_FacetFrame facets; // for the rules of the paper
    bool streams;           // surfaces show disjoint samples (math/surface_stream.glsl), and may have none
};

// The merges of one insertion. First, surface `from` merges into `into` and has the share `moved` of the result. Then
// the fragment merges into `to` and has the share `share`. AGAA_NO_SURFACE means no merge, or that the fragment is
// discarded. into = limit means the fragment.
struct agaa_Insertion {
    uint from, into;
    real moved;
    real movedLength; // length of the mean of the two normals, 1 if they agree
    uint to;
    real share;
    real shareLength;
    bool isSecond;  // the pixel was full, and the fragment merged with no surface at first
    bool hasMerged; // a surface or the fragment merged into another
    uint lost;     // number of visible samples that no surface has any more
};

agaa_Insertion agaa_noInsertion() {
    return agaa_Insertion(AGAA_NO_SURFACE, AGAA_NO_SURFACE, real(0.0), real(1.0), AGAA_NO_SURFACE, real(1.0), real(1.0),
                          false, false, 0u);
}

uint agaa_keptCount = 0u;

#if AGAA_SHARED_SURFACES
void agaa_keep(uint i, agaa_CoveredSurface s);
agaa_CoveredSurface agaa_keptAt(uint i);
#else
agaa_CoveredSurface agaa_kept[AGAA_MAX_KEPT + 1u]; // the last is the current fragment

// Stores a surface. It precedes all readers, because compilers warn about reads that precede writes.
void agaa_keep(uint i, agaa_CoveredSurface s) {
    agaa_kept[i] = s;
}

agaa_CoveredSurface agaa_keptAt(uint i) {
    return agaa_kept[i];
}
#endif

// Returns the lowest and highest depth that the range allows.
rvec2 agaa_rangeOf(agaa_CoveredSurface s) {
    return rvec2(s.depths.x - s.depths.y, s.depths.x + s.depths.z);
}

// Returns the lowest and highest depth over the pixel.
rvec2 agaa_depthInterval(agaa_CoveredSurface s) {
    const rvec2 range = agaa_rangeOf(s);
    const real reach = real(0.5) * (abs(s.plane.y) + abs(s.plane.z));
    return clamp(rvec2(s.plane.x - reach, s.plane.x + reach), rvec2(range.x), rvec2(range.y));
}

real agaa_centreDepth(agaa_CoveredSurface s) {
    const rvec2 range = agaa_rangeOf(s);
    return clamp(s.plane.x, range.x, range.y);
}

// Returns the overlap of two intervals; a negative value is their distance.
real agaa_intervalOverlap(rvec2 a, rvec2 b) { return min(a.y, b.y) - max(a.x, b.x); }

real agaa_depthOverlap(agaa_CoveredSurface a, agaa_CoveredSurface b) {
    return agaa_intervalOverlap(agaa_depthInterval(a), agaa_depthInterval(b));
}

// Merges b into a by weights, whose sum is above 0. Depths are averaged only if they overlap. Returns the share of b
// and the length of the mean normal.
// mask   The part of b's coverage that a receives.
rvec2 agaa_mergeKept(INOUT(agaa_CoveredSurface) a, agaa_CoveredSurface b, uvec4 mask, uint countA, uint countB,
                     real slack) {
    const real share = real(countB) / real(countA + countB);
    if (agaa_depthOverlap(a, b) + slack >= real(0.0)) {
        a.plane += (b.plane - a.plane) * share;
        const rvec2 ofA = agaa_rangeOf(a);
        const rvec2 ofB = agaa_rangeOf(b);
        const rvec2 range = rvec2(min(ofA.x, ofB.x), max(ofA.y, ofB.y));
        const real halfRange = (range.y - range.x) * real(0.5);
        a.depths = rvec3((range.x + range.y) * real(0.5), halfRange, halfRange);
    }
    const rvec3 normal = a.normal + (b.normal - a.normal) * share;
    const real l2 = dot(normal, normal);
    // Opposite normals of equal weight have no mean.
    a.normal = l2 > real(1e-12) ? normal * (real(1.0) / sqrt(l2)) : a.normal;
    a.mask = a.mask | mask;
    return rvec2(share, min(sqrt(l2), real(1.0)));
}

// Like agaa_mergeKept(), into surface i.
rvec2 agaa_mergeInto(uint i, agaa_CoveredSurface b, uvec4 mask, uint countA, uint countB, real slack) {
    agaa_CoveredSurface a = agaa_keptAt(i);
    const rvec2 merged = agaa_mergeKept(a, b, mask, countA, countB, slack);
    agaa_keep(i, a);
    return merged;
}

// Returns the cosine between the normals that the rule compares.
real agaa_alignment(agaa_CoveredSurface a, agaa_CoveredSurface b, agaa_MergeRules rules) {
    if (agaa_countsShown(rules.rule))
        return dot(a.normal, b.normal);
    return dot(agaa_facetNormal(rules.facets, a.plane), agaa_facetNormal(rules.facets, b.plane));
}

// Returns the surface with aligned normal and overlapping depths (section 3.2). The closest normal wins, then the
// largest overlap.
uint agaa_findAligned(agaa_CoveredSurface s, agaa_MergeRules rules) {
    uint best = AGAA_NO_SURFACE;
    real closest = real(0.0);
    real largest = real(0.0);
    for (uint i = 0u; i < agaa_keptCount; ++i) {
        const real cosine = agaa_alignment(agaa_keptAt(i), s, rules);
        const real overlap = agaa_depthOverlap(agaa_keptAt(i), s);
        const uvec4 mask = agaa_keptAt(i).mask;
        const bool isDisjoint = agaa_coverageCount(mask & s.mask) == 0u;
        const bool mayMerge = rules.streams ? isDisjoint && agaa_coverageCount(mask) != 0u
                                            : !agaa_countsShown(rules.rule) || isDisjoint;
        if (mayMerge && cosine > rules.cosine && overlap + rules.slack >= real(0.0) &&
            (best == AGAA_NO_SURFACE || cosine > closest || (cosine == closest && overlap > largest))) {
            best = i;
            closest = cosine;
            largest = overlap;
        }
    }
    return best;
}

// Returns whether a is in front of b by the depths at the pixel's centre. The lower index breaks ties.
bool agaa_isInFront(uint a, uint b) {
    const real x = agaa_centreDepth(agaa_keptAt(a));
    const real y = agaa_centreDepth(agaa_keptAt(b));
    return x < y || (x == y && a < b);
}

// Returns the samples of surface i that none of `count` surfaces covers in front of it. This is the coarse depth
// resolve.
uvec4 agaa_visibleOf(uint i, uint count) {
    uvec4 visible = agaa_keptAt(i).mask;
    for (uint k = 0u; k < count; ++k) {
        if (k != i && agaa_isInFront(k, i))
            visible = visible & ~agaa_keptAt(k).mask;
    }
    return visible;
}

// Returns the surface with the fewest visible samples except the closest one, without which thin objects would pop
// (section 3.3). The last one wins ties. count: 2 or more.
uint agaa_findLeast(uint count) {
    uint closest = 0u;
    for (uint i = 1u; i < count; ++i)
        closest = agaa_isInFront(i, closest) ? i : closest;
    uint least = AGAA_NO_SURFACE;
    uint fewest = 0u;
    for (uint i = 0u; i < count; ++i) {
        const uint bits = agaa_coverageCount(agaa_visibleOf(i, count));
        if (i != closest && (least == AGAA_NO_SURFACE || bits <= fewest)) {
            least = i;
            fewest = bits;
        }
    }
    return least;
}

// Returns the surface, of `count`, whose depths overlap most with those of i.
uint agaa_findOverlapping(uint i, uint count, real slack) {
    uint best = AGAA_NO_SURFACE;
    real largest = real(0.0);
    for (uint k = 0u; k < count; ++k) {
        const real overlap = agaa_depthOverlap(agaa_keptAt(k), agaa_keptAt(i));
        if (k != i && overlap + slack >= real(0.0) && (best == AGAA_NO_SURFACE || overlap > largest)) {
            best = k;
            largest = overlap;
        }
    }
    return best;
}

// Returns the cosine that the largest difference of colours counts as. Other values were not compared.
real agaa_colorWeight() { return real(2.0); }

// The merge of a surface into its target.
struct agaa_KeptMerge {
    uint from;
    uint into;
    uvec4 visible; // samples that show the surface
    real cost;     // weighted by the number of these samples
};

// Returns the merge of surface i, of `count` surfaces, 2 or more, into the one with the closest normal among those
// whose depths overlap, otherwise into the nearest in depth. The weights of a difference in depth, and of each sample,
// come from measurement.
agaa_KeptMerge agaa_mergeOf(uint i, uint count, bool byColor) {
    const agaa_CoveredSurface s = agaa_keptAt(i);
    const rvec2 interval = agaa_depthInterval(s);
    const real centre = agaa_centreDepth(s);
    agaa_KeptMerge merge = agaa_KeptMerge(i, AGAA_NO_SURFACE, s.mask, real(0.0));
    bool bestOverlaps = false;
    real highest = real(0.0);
    real cosine = real(0.0);
    for (uint k = 0u; k < count; ++k) {
        const agaa_CoveredSurface other = agaa_keptAt(k);
        const real overlap = agaa_intervalOverlap(agaa_depthInterval(other), interval);
        real alignment = dot(other.normal, s.normal);
        if (byColor && k != i)
            alignment -= agaa_colorWeight() * AGAA_COLOR_DIFFERENCE(i, k);
        const bool overlaps = overlap >= real(0.0);
        const real rank = overlaps ? alignment : overlap;
        if (k != i && (merge.into == AGAA_NO_SURFACE || (overlaps && !bestOverlaps) ||
                       (overlaps == bestOverlaps && rank > highest))) {
            merge.into = k;
            bestOverlaps = overlaps;
            highest = rank;
            cosine = alignment;
        }
        const real depth = agaa_centreDepth(other);
        if (k != i && (depth < centre || (depth == centre && k < i)))
            merge.visible = merge.visible & ~other.mask;
    }
    const real apart = bestOverlaps ? real(0.0) : real(0.5);
    merge.cost = real(agaa_coverageCount(merge.visible)) * (real(1.1) - cosine + apart);
    return merge;
}

// Returns the cheapest merge of `count` surfaces. The last one wins ties.
agaa_KeptMerge agaa_cheapestMerge(uint count, bool byColor) {
    agaa_KeptMerge cheapest = agaa_mergeOf(0u, count, byColor);
    for (uint i = 1u; i < count; ++i) {
        const agaa_KeptMerge merge = agaa_mergeOf(i, count, byColor);
        if (merge.cost <= cheapest.cost)
            cheapest = merge;
    }
    return cheapest;
}

// Returns the merge of the surface with the fewest visible samples, as the paper has it.
agaa_KeptMerge agaa_paperMerge(uint count, agaa_MergeRules rules) {
    const uint least = agaa_findLeast(count);
    const uint into = rules.rule == AGAA_RULE_NONE ? AGAA_NO_SURFACE : agaa_findOverlapping(least, count, rules.slack);
    return agaa_KeptMerge(least, into, agaa_visibleOf(least, count), real(0.0));
}

// Inserts the fragment agaa_keptAt(rules.limit) into a full pixel.
agaa_Insertion agaa_insertInFull(agaa_MergeRules rules) {
    agaa_Insertion done = agaa_noInsertion();
    done.isSecond = true;
    const uint count = rules.limit + 1u;
    const bool byCost = agaa_countsShown(rules.rule);
    agaa_KeptMerge merge;
    if (byCost)
        merge = agaa_cheapestMerge(count, rules.rule == AGAA_RULE_COLOR);
    else
        merge = agaa_paperMerge(count, rules);
    const uint least = merge.from;
    const uvec4 moving = byCost ? merge.visible : agaa_keptAt(least).mask;
    const uint target = agaa_coverageCount(moving) != 0u ? merge.into : AGAA_NO_SURFACE;
    if (target == AGAA_NO_SURFACE) {
        done.lost = agaa_coverageCount(merge.visible);
    } else {
        done.hasMerged = true;
        const uvec4 targetMask = byCost ? agaa_visibleOf(target, count) : agaa_keptAt(target).mask;
        const rvec2 merged = agaa_mergeInto(target, agaa_keptAt(least), moving, agaa_coverageCount(targetMask),
                                            agaa_coverageCount(moving), rules.slack);
        if (least == rules.limit) {
            done.to = target;
            done.share = merged.x;
            done.shareLength = merged.y;
        } else {
            done.from = least;
            done.into = target;
            done.moved = merged.x;
            done.movedLength = merged.y;
        }
    }
    if (least != rules.limit) {
        agaa_keep(least, agaa_keptAt(rules.limit));
        done.to = least;
    }
    return done;
}

// Inserts a fragment, which must cover a sample.
agaa_Insertion agaa_insertSurface(agaa_CoveredSurface s, agaa_MergeRules rules) {
    agaa_Insertion done = agaa_noInsertion();
    done.to = agaa_findAligned(s, rules);
    if (done.to != AGAA_NO_SURFACE) {
        done.hasMerged = true;
        const rvec2 merged = agaa_mergeInto(done.to, s, s.mask, agaa_coverageCount(agaa_keptAt(done.to).mask),
                                            agaa_coverageCount(s.mask), rules.slack);
        done.share = merged.x;
        done.shareLength = merged.y;
    } else if (agaa_keptCount < rules.limit) {
        done.to = agaa_keptCount;
        agaa_keep(agaa_keptCount, s);
        agaa_keptCount = agaa_keptCount + 1u;
    } else {
        agaa_keep(rules.limit, s);
    }
    if (done.to == AGAA_NO_SURFACE)
        done = agaa_insertInFull(rules);
    return done;
}
#endif
