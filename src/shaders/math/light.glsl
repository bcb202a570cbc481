// Light falloff and the shading of one sample or aggregate for one light direction.
// Sources: AGAA (Crassin et al., TVCG 2016) sections 3.5.1 and 3.5.2; Karis 2013, "Real Shading in
// Unreal Engine 4" (windowed inverse square, representative points); hard cases 39, 40, 65 and 66.
#ifndef AGAA_MATH_LIGHT_GLSL
#define AGAA_MATH_LIGHT_GLSL
#include "brdf.glsl"
#include "ndf.glsl"
#include "real.glsl"

#define agaa_brdfBlinnPhong 0u // AGAA_BRDF_BLINN_PHONG; GGX otherwise

// The least squared distance, which only keeps quotients finite. Scenes may have any unit of length.
real agaa_leastDistance2() {
    return real(1e-28);
}

// Returns the inverse square law with a window that reaches 0 at `range`; a range of 0 has no window. d2 is the squared
// distance, rMin2 the squared radius of the lamp, within which the law would diverge.
real agaa_pointAttenuation(real d2, real range, real rMin2) {
    real window = real(1.0);
    if (range > real(0.0)) {
        const real q = min(d2 / max(range * range, agaa_leastDistance2()), real(1.0));
        window = agaa_sq(real(1.0) - q * q);
    }
    return window / max(d2, max(rMin2, agaa_leastDistance2()));
}

// Returns the unit vector along toLight. Within a thousandth of the lamp's radius it approaches the zero vector, which
// lights nothing.
rvec3 agaa_lightDirection(rvec3 toLight, real rMin2) {
    const real d2 = dot(toLight, toLight);
    const real scale = real(1.0) / sqrt(max(d2, max(rMin2 * real(1e-6), agaa_leastDistance2())));
    return rvec3(toLight.x * scale, toLight.y * scale, toLight.z * scale);
}

// A shading event at the mean position of an aggregate stands for the mean over its samples. The two functions keep
// this mean bounded if a light is nearer than the aggregate is wide, and do not change far lights, whose error by the
// spread is of the fourth order. Their constants are fitted to the irradiance of a square (hard case 65).
// spread   Mean squared distance of the samples from the position of the event.

// Returns the squared distance by which a light is attenuated: the root of d2^2 + spread^2.
real agaa_spreadDistance2(real d2, real spread) {
    const real larger = max(d2, max(spread, agaa_leastDistance2()));
    const real ratio = min(d2, spread) / larger;
    return larger * sqrt(real(1.0) + ratio * ratio);
}

// Returns the vector to a light from the part of an aggregate that it lights most: the point nearest to the light of a
// disc across the normal. The whole aggregate would otherwise be lit at the grazing angle of its mean position.
rvec3 agaa_nearestToLight(rvec3 toLight, rvec3 normal, real spread) {
    const real height = dot(normal, toLight);
    const rvec3 side = toLight - normal * height;
    const real side2 = dot(side, side);
    const real nearness = spread / agaa_spreadDistance2(dot(toLight, toLight), spread);
    const real radius2 = real(3.0) * spread * nearness * nearness;
    const real left = side2 > radius2 ? real(1.0) - sqrt(radius2 / side2) : real(0.0);
    return normal * height + side * left;
}

// Returns the attenuation of a spot light, linear in the cosine between the two cones. Equal cones make a step of width
// 1e-4.
real agaa_spotCone(real cosAngle, real cosInner, real cosOuter) {
    return agaa_saturate((cosAngle - cosOuter) / max(cosInner - cosOuter, real(1e-4)));
}

struct agaa_Surface {
    rvec3 diffuse;
    rvec3 specular; // reflectance at normal incidence
    rvec3 emissive;
    rvec3 normal;    // unit
    real meanLength; // of the mean normal: 1 for a single sample
    real alpha2;     // already widened, by agaa_toksvigAlpha2 or agaa_spreadAlpha2
    // Elliptic lobes have alpha2Along along axis, a unit vector perpendicular to the normal, and alpha2 across.
    real alpha2Along;
    rvec3 axis;
};

real agaa_roundLobe(agaa_Surface s, rvec3 n, rvec3 v, rvec3 l, rvec3 h, uint brdf) {
    const real noL = agaa_saturate(dot(n, l));
    const rvec3 c = cross(n, h);
    const real NxH2 = min(dot(c, c), real(1.0));
    const real NoH = agaa_saturate(dot(n, h));
    if (brdf == agaa_brdfBlinnPhong) {
        return real(0.25) * agaa_blinnPhong(agaa_exponentFromAlpha2(s.alpha2), NxH2, NoH);
    }
    // Interpolated normals may face away from the eye; the floor keeps Smith's term bounded.
    const real NoV = clamp(dot(n, v), real(1e-4), real(1.0));
    return agaa_ggxD(s.alpha2, NoH, NxH2) * agaa_ggxV(s.alpha2, NoV, noL);
}

real agaa_ellipticLobe(agaa_Surface s, rvec3 n, rvec3 v, rvec3 l, rvec3 h, uint brdf) {
    const rvec3 x = clamp(s.axis, real(-1.0), real(1.0));
    const rvec3 y = cross(n, x);
    const rvec3 hAt = rvec3(dot(x, h), dot(y, h), agaa_saturate(dot(n, h)));
    if (brdf == agaa_brdfBlinnPhong) {
        return real(0.25) * agaa_blinnPhongEllipse(s.alpha2Along, s.alpha2, hAt);
    }
    const rvec3 vAt = rvec3(dot(x, v), dot(y, v), clamp(dot(n, v), real(1e-4), real(1.0)));
    const rvec3 lAt = rvec3(dot(x, l), dot(y, l), dot(n, l));
    return agaa_ggxEllipseD(s.alpha2Along, s.alpha2, hAt) *
           agaa_ggxEllipseV(s.alpha2Along, s.alpha2, vAt, lAt);
}

// Returns the diffuse term times cosine for unit radiance from l, a unit vector away from the surface.
// filterDiffuse   AGAA_FILTER_DIFFUSE, except for SGGX.
rvec3 agaa_shadeDiffuse(agaa_Surface s, rvec3 l, uint filterDiffuse) {
    const rvec3 n = clamp(s.normal, real(-1.0), real(1.0));
    const rvec3 toLight = clamp(l, real(-1.0), real(1.0));
    const rvec3 albedo = clamp(s.diffuse, real(0.0), real(1.0));
    const real noL = clamp(dot(n, toLight), real(-1.0), real(1.0));
    real diffuse = max(noL, real(0.0));
    if (filterDiffuse == agaa_diffuseMisesFisher) {
        diffuse = agaa_misesFisherDiffuse(noL, s.meanLength);
    } else if (filterDiffuse != 0u) {
        diffuse = agaa_rectifiedDiffuse(noL * agaa_saturate(s.meanLength), noL, s.meanLength);
    }
    diffuse = diffuse / agaa_pi();
    return rvec3(albedo.x * diffuse, albedo.y * diffuse, albedo.z * diffuse);
}

// Returns the diffuse and specular terms times cosine for unit radiance from l. The Fresnel factor is not 0 where
// `specular` is 0. Vectors and reflectances are clamped to their valid ranges first, so that finite inputs give a
// finite colour. Both lobes have Schlick's Fresnel term, so that a change of lobe changes the lobe only.
// v          Unit vector away from the surface, to the eye.
// brdf       0: Blinn-Phong with the exponent of the same width and the implicit visibility 1/4; 1: GGX with
//            height-correlated Smith.
// elliptic   1: the lobe has the width alpha2Along along axis.
rvec3 agaa_shade(agaa_Surface s, rvec3 v, rvec3 l, uint brdf, uint filterDiffuse,
                 uint elliptic) {
    const rvec3 n = clamp(s.normal, real(-1.0), real(1.0));
    const rvec3 toEye = clamp(v, real(-1.0), real(1.0));
    const rvec3 toLight = clamp(l, real(-1.0), real(1.0));
    const rvec3 f0 = clamp(s.specular, real(0.0), real(1.0));
    const real cosine = max(clamp(dot(n, toLight), real(-1.0), real(1.0)), real(0.0));
    const rvec3 diffuse = agaa_shadeDiffuse(s, l, filterDiffuse);

    real lobe = real(0.0);
    rvec3 fresnel = f0;
    if (cosine > real(0.0)) {
        // Opposite v and l have no half vector; the normal is its limit in the plane of reflection.
        rvec3 h = rvec3(toEye.x + toLight.x, toEye.y + toLight.y, toEye.z + toLight.z);
        const real h2 = dot(h, h);
        if (h2 > real(1e-10)) {
            const real scale = real(1.0) / sqrt(h2);
            h = rvec3(h.x * scale, h.y * scale, h.z * scale);
        } else {
            h = n;
        }
        fresnel = agaa_fresnelSchlick(f0, dot(toEye, h));
        if (elliptic != 0u) {
            lobe = agaa_ellipticLobe(s, n, toEye, toLight, h, brdf) * cosine;
        } else {
            lobe = agaa_roundLobe(s, n, toEye, toLight, h, brdf) * cosine;
        }
    }
    return rvec3(diffuse.x + fresnel.x * lobe, diffuse.y + fresnel.y * lobe,
                 diffuse.z + fresnel.z * lobe);
}

// Returns the variance of the direction to a light over the positions of a surface, of both axes across the direction
// together, [0, 1).
// positions   Second moments around the position.
// d           From the position to the light.
real agaa_directionVariance(agaa_SecondMoments positions, rvec3 d) {
    const real d2 = dot(d, d);
    const real trace = positions.squares.x + positions.squares.y + positions.squares.z;
    const real along = d2 > real(0.0) ? agaa_momentAlong(positions, d, d) / d2 : real(0.0);
    const real across = max(trace - along, real(0.0));
    // A light within the surface is in all directions: the mean of its squared distance is d2 + trace.
    return across > real(0.0) ? across / (d2 + across) : real(0.0);
}

// Widens the lobes of a surface for a light whose direction varies, as if the normals did (AGAA 3.5.2). The half vector
// turns by half of the angle, and alpha2 is twice the variance of slopes in one direction.
void agaa_addDirectionVariance(INOUT(agaa_Surface) s, real variance) {
    s.meanLength = s.meanLength * sqrt(max(real(1.0) - variance, real(0.0)));
    const real widening = real(0.25) * variance;
    s.alpha2 = min(s.alpha2 + widening, real(1.0));
    s.alpha2Along = s.alpha2Along > real(0.0) ? min(s.alpha2Along + widening, real(1.0)) : real(0.0);
}

#endif
