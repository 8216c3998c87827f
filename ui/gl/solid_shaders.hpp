// The shaders of worlds in space. Depths are those of OrbitLens: `depths` holds how a depth d comes to OpenGL's z, which is
// x - y / d, and how many cells lines are drawn nearer than they are. build_program() adds the line of the version.
#pragma once

// The shade of each of the six sides: literals are joined by their standing side by side, which takes a macro.
#define REPLAN_SIDE_LIGHT                                                                           \
  "const float kLight[6] = float[6](-0.10, 0.04, -0.28, 0.12, -0.45, 0.26);\n"                      \
  "vec4 lit(vec4 colour, int side) {\n"                                                             \
  "  float by = kLight[side];\n"                                                                    \
  "  return vec4(by > 0.0 ? mix(colour.rgb, vec3(1.0), by) : colour.rgb * (1.0 + by), colour.a);\n" \
  "}\n"

namespace replan::ui {

// Faces are rectangles of cells: one instance each, its corners from the number of the vertex. The light comes from above
// and is soft: each side has its own shade, lighter or darker than its colour. What is far away fades into the background.
// Lines between cells are a little darker, and vanish where cells are small. In worlds of many layers what is high is lighter
// than what is low.
inline constexpr const char* kFaceVertices = REPLAN_SIDE_LIGHT R"(
layout(location = 0) in vec3 cell;
layout(location = 1) in float side;
layout(location = 2) in vec2 extent;
layout(location = 3) in vec4 colour;
uniform mat4 projection;
uniform float lift;
uniform vec2 ramp;  // how much lighter the highest place is than the lowest; the highest
out vec3 place;
out vec2 on_face;
out vec4 shade;
out float depth;
void main() {
  int s = int(side + 0.5);
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  if (s == 1 || s == 2 || s == 5) corner = corner.yx;  // all turn the same way, seen from outside
  on_face = corner * extent;
  vec3 at = cell;
  float out_by = (s & 1) == 1 ? 1.0 + lift : -lift;
  if (s < 2) at += vec3(out_by, on_face.x, on_face.y);
  else if (s < 4) at += vec3(on_face.x, out_by, on_face.y);
  else at += vec3(on_face.x, on_face.y, out_by);
  place = at;
  shade = lit(colour, s);
  shade.rgb *= 1.0 + ramp.x * (at.z / ramp.y - 0.7);
  gl_Position = projection * vec4(at, 1.0);
  depth = gl_Position.w;
}
)";

inline constexpr const char* kFaceFragments = R"(
in vec3 place;
in vec2 on_face;
in vec4 shade;
in float depth;
uniform vec4 cut;      // the plane's normal and its place along it: what is beyond is left out
uniform vec2 finish;   // opacity; strength of the lines between cells
uniform vec4 haze;     // the background's colour, and how much of it the farthest place has
uniform vec2 reach;    // depths between which it thickens
layout(location = 0) out vec4 result;
void main() {
  if (dot(place, cut.xyz) > cut.w) discard;
  vec2 width = max(fwidth(on_face), vec2(1e-5));
  vec2 line = abs(fract(on_face - 0.5) - 0.5) / width;
  float near = 1.0 - min(min(line.x, line.y), 1.0);
  float seen = clamp(1.0 - max(width.x, width.y) * 3.0, 0.0, 1.0);
  vec3 drawn = shade.rgb * (1.0 - finish.y * near * seen);
  float far = clamp((depth - reach.x) / (reach.y - reach.x), 0.0, 1.0);
  result = vec4(mix(drawn, haze.rgb, haze.a * far), shade.a * finish.x);
}
)";

// Of a small cube the three sides that look at the eye.
inline constexpr const char* kBoxVertices = REPLAN_SIDE_LIGHT R"(
layout(location = 0) in vec3 low;
layout(location = 1) in vec3 high;
layout(location = 2) in vec4 colour;
uniform mat4 projection;
uniform vec4 eye;
out vec4 shade;
const int kCorner[6] = int[6](0, 1, 2, 2, 1, 3);
void main() {
  int axis = gl_VertexID / 6;
  int s = axis * 2 + (eye[axis] * 2.0 > low[axis] + high[axis] ? 1 : 0);
  int c = kCorner[gl_VertexID % 6];
  vec2 corner = vec2(float(c & 1), float(c >> 1));
  if (s == 1 || s == 2 || s == 5) corner = corner.yx;
  float out_by = (s & 1) == 1 ? 1.0 : 0.0;
  vec3 part = s < 2 ? vec3(out_by, corner) : s < 4 ? vec3(corner.x, out_by, corner.y) : vec3(corner, out_by);
  shade = lit(colour, s);
  gl_Position = projection * vec4(mix(low, high, part), 1.0);
}
)";

inline constexpr const char* kPlainFragments = R"(
in vec4 shade;
uniform vec2 finish;
layout(location = 0) out vec4 result;
void main() { result = vec4(shade.rgb, shade.a * finish.x); }
)";

// A piece of a line becomes a rectangle as many pixels wide as it is to be. Its
// depth is that of a line so many cells nearer to the eye: over the faces that it lies on, and behind what hides it.
inline constexpr const char* kLineVertices = R"(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colour;
layout(location = 3) in float width;
uniform mat4 projection;
uniform vec2 viewport;
uniform vec4 depths;
uniform vec2 finish;  // opacity; how much of its width the ends are drawn out, so that joints are closed
out vec4 shade;
void main() {
  vec4 a = projection * vec4(from, 1.0), b = projection * vec4(to, 1.0);
  float least = 0.001;
  if (a.w < least && b.w >= least) a = mix(b, a, (b.w - least) / (b.w - a.w));
  if (b.w < least && a.w >= least) b = mix(a, b, (a.w - least) / (a.w - b.w));
  vec2 pa = a.xy / a.w * viewport, pb = b.xy / b.w * viewport;
  vec2 way = pb - pa;
  float far = length(way);
  vec2 ahead = far > 1e-4 ? way / far : vec2(1.0, 0.0);
  vec2 aside = vec2(-ahead.y, ahead.x) * width * (float(gl_VertexID & 1) * 2.0 - 1.0);
  bool last = gl_VertexID > 1;
  vec4 at = last ? b : a;
  vec2 drawn_out = ahead * width * finish.y * (last ? 1.0 : -1.0);
  float nearer = at.w - min(depths.z, 0.5 * at.w);
  shade = colour;
  gl_Position = vec4(at.xy + (aside + drawn_out) / viewport * at.w, at.w * (depths.x - depths.y / nearer), at.w);
}
)";

inline constexpr const char* kSheetVertices = R"(
uniform mat4 projection;
uniform vec4 corner;
uniform vec4 right;
uniform vec4 down;
out vec2 texel;
void main() {
  texel = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
  vec3 at = corner.xyz + texel.x * (right.xyz - corner.xyz) + texel.y * (down.xyz - corner.xyz);
  gl_Position = projection * vec4(at, 1.0);
}
)";

inline constexpr const char* kSheetFragments = R"(
in vec2 texel;
uniform sampler2D picture;
uniform vec2 finish;
layout(location = 0) out vec4 result;
void main() {
  vec4 colour = texture(picture, texel);
  if (colour.a == 0.0) discard;
  result = vec4(colour.rgb, colour.a * finish.x);
}
)";

// Outlines: ink where what lies beside a pixel is farther away than a flat face would be there. Over a flat face OpenGL's z
// is linear on the screen, so that its second difference is 0. Edges between faces are left out where cells are small.
inline constexpr const char* kOutlineVertices = R"(
void main() {
  gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

inline constexpr const char* kOutlineFragments = R"(
uniform sampler2D picture;  // the depths
uniform vec4 depths;
uniform vec2 viewport;
uniform vec2 finish;        // how many cells a pixel is at a depth of one; pixels to the neighbour
uniform vec4 ink;
layout(location = 0) out vec4 result;
float z_at(vec2 by) {
  ivec2 at = clamp(ivec2(gl_FragCoord.xy + by), ivec2(0), ivec2(viewport) - 1);
  return texelFetch(picture, at, 0).r * 2.0 - 1.0;
}
void main() {
  float z = z_at(vec2(0.0));
  if (z > 0.99999) discard;
  float beside = finish.y;
  float across = z_at(vec2(-beside, 0.0)) + z_at(vec2(beside, 0.0)) - 2.0 * z;
  float down = z_at(vec2(0.0, -beside)) + z_at(vec2(0.0, beside)) - 2.0 * z;
  float depth = depths.y / (depths.x - z);
  float cells = max(across, down) * depth * depth / depths.y;
  float pixel = depth * finish.x * beside;
  float edge = smoothstep(0.8, 2.5, cells / pixel) * 0.6 * (1.0 - smoothstep(0.2, 0.5, pixel));
  float outline = smoothstep(1.0 + pixel, 4.0 + 6.0 * pixel, cells);
  result = vec4(ink.rgb, ink.a * max(edge, outline));
}
)";

}  // namespace replan::ui

#undef REPLAN_SIDE_LIGHT
