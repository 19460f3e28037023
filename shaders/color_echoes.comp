// Autocorrelation of the echoes at each point of the lattice of color: ReferenceColor::echoAt().
#include "frame.glsl"
#include "field.glsl"
#include "geometry.glsl"
#include "color.glsl"
#include "color_tissue.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 4) readonly buffer Flow {
  // By segment of a center line: first point and radius, their changes to the second point; direction of the flow and
  // scale of the velocity, their changes; 1 / squared length, channel, tube. Then the profiles of the tubes.
  vec4 flow[];
};
layout(std430, binding = 6) readonly buffer Passed {
  float passed[];
};
layout(std430, binding = 7) writeonly buffer Echoes {
  float echoes[];
};

float profileAt(int tube, float fromCenter) {
  float at = fromCenter * float(kProfilePoints - 1);
  int low = min(int(at), kProfilePoints - 2), high = low + 1;
  int first = color.profileTable + tube * ((kProfilePoints + 3) / 4);
  return mix(flow[first + (low >> 2)][low & 3], flow[first + (high >> 2)][high & 3], at - float(low));
}

// Velocity of the blood along the beam, in the vessel that contains a point: FlowSegments::along().
float bloodAlong(int channel, vec3 at_mm, float depth_mm, vec3 beam) {
  float least2 = kReach_radii * kReach_radii, off2 = 0.0, along = 0.0;
  int best = -1;
  for (int s = 0; s < color.segments; ++s) {
    vec4 tail = flow[5 * s + 4];
    if (int(tail.y) != channel) continue;
    vec4 a = flow[5 * s], change = flow[5 * s + 1];
    vec3 from = at_mm - a.xyz;
    float t = clamp(dot(from, change.xyz) * tail.x, 0.0, 1.0);
    vec3 off = from - t * change.xyz;
    float radius_mm = a.w + t * change.w, radii2 = dot(off, off) / (radius_mm * radius_mm);
    if (radii2 >= least2) continue;
    least2 = radii2, off2 = dot(off, off), along = t, best = s;
  }
  if (best < 0) return 0.0;
  float off_mm = sqrt(off2);
  vec4 direction = flow[5 * best + 2] + along * flow[5 * best + 3];
  return direction.w * profileAt(int(flow[5 * best + 4].z), off_mm / (off_mm + depth_mm)) * dot(direction.xyz, beam);
}

// Power, and real and imaginary part at a lag of one pulse, after the wall filter.
vec3 echoOf(int channel, float toward_mmps) {
  float turns = toward_mmps * color.turnsPerVelocity;
  turns -= round(turns);
  float power = color.echoPower[channel].x;
  if (color.perCutoff > 0.0) {
    // Above 30 cutoffs, the filter passes everything, and the power would overflow.
    float ratio = pow(min(abs(turns) * color.perCutoff, 30.0), kWallFilterPower);
    power *= ratio / (1.0 + ratio);
  }
  float phase = 6.28318530718 * turns;
  return power * vec3(1, cos(phase), sin(phase));
}

vec3 echoAt(vec3 rest_mm, vec3 beam) {
  float distance_mm[16];
  int nearest = lookUp(rest_mm, distance_mm);
  float tissue_mmps = -dot(color.tissue_mmps.xyz, beam), left = 1.0;
  vec3 sum = vec3(0);
  for (int kind = 0; kind < 2; ++kind) {
    int channel = kind == 0 ? color.artery : color.vein;
    if (channel < 0) continue;
    float share = min(clamp(0.5 - distance_mm[channel] / kBloodEdge_mm, 0.0, 1.0), left);
    if (share > 0.0) {
      float away_mmps = bloodAlong(channel, rest_mm, max(-distance_mm[channel], kLeastDepth_mm), beam);
      sum += share * echoOf(channel, tissue_mmps - away_mmps);
      left -= share;
    }
  }
  return sum + left * echoOf(nearest, tissue_mmps);
}

void main() {
  int gate = min(int(gl_GlobalInvocationID.x), color.fineGates - 1), line = int(gl_GlobalInvocationID.y);
  vec2 rest = restBetween(line, 0, gate);
  vec4 ray = planTable[color.lineTable + line];
  vec3 sum = vec3(0);
  for (int plane = 0; plane < 3; ++plane)
    sum += color.plane[plane].y * echoAt(vec3(rest.x, color.plane[plane].x, rest.y), vec3(ray.x, 0, ray.y));
  sum *= passed[line * color.fineGates + gate];
  for (int component = 0; component < 3; ++component) echoes[fineIndex(component, line, gate)] = sum[component];
}
