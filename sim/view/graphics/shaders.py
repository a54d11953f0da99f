"""Shaders: one light, one shadow map, one fog for everything.

SHADOWS, the samples of the shadow map per point, is set when a program is made: a processor that draws runs both sides of an
`if`, so what a quality does without must not be in its program.
"""

VERSION = "#version 330\n"
COMMON = """
uniform mat4 view_projection;
uniform mat4 sun_projection;
uniform vec3 eye;
uniform vec3 sun;
uniform float time;
uniform float haze;                     // distance over which things fade [m]
"""

LIGHT = """
uniform sampler2DShadow shadow_map;
vec3 sky_colour(vec3 d) {
    vec3 sky = mix(vec3(0.86, 0.90, 0.92), vec3(0.36, 0.58, 0.85), sqrt(clamp(d.z, 0.0, 1.0)));
    float glow = max(dot(d, sun), 0.0);
    glow *= glow; glow *= glow; glow *= glow;
    return sky + vec3(1.0, 0.85, 0.6) * (0.18 * glow);
}
#if SHADOWS == 0
float lit(vec3 p, float facing) { return 1.0; }
#else
float lit(vec3 p, float facing) {
    vec3 s = (sun_projection * vec4(p, 1.0)).xyz * 0.5 + 0.5;
    vec3 off = abs(s - 0.5);
    float outside = step(0.5, max(off.x, max(off.y, off.z)));
    s.z -= 0.0006 + 0.0015 * (1.0 - facing);
#if SHADOWS == 1
    return max(texture(shadow_map, s), outside);
#else
    float texel = 0.75 / float(textureSize(shadow_map, 0).x);
    vec4 o = vec4(-texel, texel, 0.0, 0.0);
    return max(0.25 * (texture(shadow_map, s + o.xxz) + texture(shadow_map, s + o.xyz)
        + texture(shadow_map, s + o.yxz) + texture(shadow_map, s + o.yyz)), outside);
#endif
}
#endif
vec3 shade(vec3 colour, vec3 p, vec3 n) {
    float facing = max(dot(n, sun), 0.0);
    float light = facing * lit(p, facing);
    vec3 ambient = mix(vec3(0.34, 0.31, 0.27), vec3(0.56, 0.63, 0.72), n.z * 0.5 + 0.5);
    vec3 away = p - eye;
    float far = length(away);
    away /= far;
    float rim = 1.0 - max(-dot(n, away), 0.0);
    vec3 c = colour * (ambient + light * vec3(0.86, 0.78, 0.62)) + (0.12 * rim * rim * rim) * vec3(0.7, 0.8, 0.9);
    float x = far / haze;
    return mix(sky_colour(away * vec3(1.0, 1.0, 0.2)), c, exp(-x * sqrt(x)));
}
vec4 tone(vec3 c) { c = clamp(c, 0.0, 1.0); return vec4(c * (1.1 - 0.1 * c), 1.0); }
"""

MESH_VERTEX = (
    COMMON
    + """
in vec3 in_position; in vec3 in_normal; in vec3 in_colour;
out vec3 p; out vec3 n; out vec3 colour;
void main() { p = in_position; n = in_normal; colour = in_colour; gl_Position = view_projection * vec4(p, 1.0); }
"""
)
MESH_FRAGMENT = (
    COMMON
    + LIGHT
    + """
in vec3 p; in vec3 n; in vec3 colour; out vec4 pixel;
void main() { pixel = tone(shade(colour, p, normalize(n))); }
"""
)

TREE_VERTEX = (
    COMMON
    + """
in vec3 in_offset; in vec3 in_normal; in vec3 in_part;  // part: height, crown or trunk, brightness
in vec4 place; in vec4 form; in vec4 leaf;              // see trees.Planted
uniform vec4 focus;                                     // place and radius of what is looked at
out vec3 p; out vec3 n; out vec3 colour; out float gone;
float near_way(vec3 at, float radius, float end) {      // 1: at hides the focus from the eye, 0: it is beside the way there
    vec3 way = focus.xyz - eye;
    float t = clamp(dot(at - eye, way) / dot(way, way), 0.0, end);
    float reach = radius * (1.4 - 0.4 * t) + focus.w * t;
    return 1.0 - smoothstep(0.95, 1.1, length(at - eye - t * way) / reach);
}
void main() {
    bool crown = in_part.y > 0.5;
    vec3 size = crown ? vec3(form.w) : vec3(place.w, place.w, form.x);
    mat3 turn = mat3(form.y, form.z, 0.0, -form.z, form.y, 0.0, 0.0, 0.0, 1.0);
    p = place.xyz + turn * (size * in_offset) + vec3(0.0, 0.0, in_part.x * form.x);
    n = turn * in_normal;
    colour = (crown ? leaf.rgb : leaf.w * vec3(0.40, 0.29, 0.20)) * in_part.z;
    float low = clamp(mix(eye.z, focus.z, 0.7) - place.z, 0.0, 0.6 * form.x);
    gone = max(near_way(place.xyz + vec3(0.0, 0.0, 0.75 * form.x), 1.05 * form.w, 0.9),
               near_way(place.xyz + vec3(0.0, 0.0, low), 2.0 * place.w, 0.95));
    gl_Position = view_projection * vec4(p, 1.0);
}
"""
)
TREE_FRAGMENT = (
    COMMON
    + LIGHT
    + """
in vec3 p; in vec3 n; in vec3 colour; in float gone; out vec4 pixel;
void main() {
    float grain = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));
    if (grain < gone) discard;   // all of the tree alike
    pixel = tone(shade(colour, p, normalize(n)));
}
"""
)

PRINT_VERTEX = (
    COMMON
    + """
in vec2 in_outline;                     // forward, left of the sole's middle
in vec4 place; in vec4 lie;             // position and heading; normal and time of contact
out vec3 p; out vec3 n; out vec3 colour;
void main() {
    vec2 ahead = vec2(cos(place.w), sin(place.w));
    n = lie.xyz;
    vec3 forward = normalize(vec3(ahead, -dot(n.xy, ahead) / n.z));
    p = place.xyz + in_outline.x * forward + in_outline.y * cross(n, forward) + 0.006 * n;
    colour = vec3(0.27, 0.24, 0.16);
    bool unseen = lie.w > time || distance(eye, place.xyz) > 55.0;  // to come, or a speck
    gl_Position = unseen ? vec4(2.0, 2.0, 2.0, 1.0) : view_projection * vec4(p, 1.0);
}
"""
)

CAPSULE_VERTEX = (
    COMMON
    + """
in vec4 in_shape;                       // direction about the axis z, share of the way from a to b
in vec4 a; in vec4 b; in vec4 paint;    // ends with radii; colour and glow
uniform float flat_shapes;              // 1: z lies along the axis as the eye sees it, y away from the eye; 0: along the axis
out vec3 p; out vec3 n; out vec4 colour;
vec3 across(vec3 d) { return normalize(cross(d, abs(d.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0))); }
void main() {
    vec3 axis = b.xyz - a.xyz, u, v, w;
    if (flat_shapes > 0.5) {
        vec3 e = normalize(eye - a.xyz);
        axis -= dot(axis, e) * e;
        w = length(axis) > 1e-4 ? normalize(axis) : across(e);
        u = cross(w, e); v = -e;
    } else {
        w = length(axis) > 1e-6 ? normalize(axis) : vec3(0.0, 0.0, 1.0);
        u = across(w); v = cross(w, u);
    }
    n = in_shape.x * u + in_shape.y * v + in_shape.z * w;
    p = mix(a.xyz, b.xyz, in_shape.w) + n * mix(a.w, b.w, in_shape.w);
    colour = paint;
    gl_Position = view_projection * vec4(p, 1.0);
}
"""
)
CAPSULE_FRAGMENT = (
    COMMON
    + LIGHT
    + """
in vec3 p; in vec3 n; in vec4 colour; out vec4 pixel;
void main() { pixel = tone(mix(shade(colour.rgb, p, normalize(n)), colour.rgb, colour.a)); }
"""
)

WATER_FRAGMENT = (
    COMMON
    + LIGHT
    + """
in vec3 p; in vec3 n; in vec3 colour; out vec4 pixel;
void main() {
    vec2 flow = n.xy;                   // direction of the stream
    vec2 q = p.xy - flow * time * 0.5;
    float a = sin(q.x * 3.1 + q.y * 1.7 + time) + sin(q.x * -2.3 + q.y * 4.3 - 1.3 * time);
    float b = cos(q.x * 5.9 - q.y * 2.9 + 1.7 * time) + cos(q.x * 1.3 + q.y * 6.1 - time);
    vec3 wave = normalize(vec3(0.035 * a, 0.035 * b, 1.0));
    vec3 d = normalize(p - eye);
    vec3 mirrored = sky_colour(reflect(d, wave));
    float fresnel = 0.08 + 0.8 * pow(1.0 - max(dot(-d, wave), 0.0), 4.0);
    vec3 deep = shade(vec3(0.09, 0.30, 0.33) + 0.02 * a, p, wave);
    pixel = tone(mix(deep, mirrored, clamp(fresnel, 0.0, 0.85)));
}
"""
)

SKY_VERTEX = (
    COMMON
    + """
in vec2 in_corner; out vec2 corner;
void main() { corner = in_corner; gl_Position = vec4(in_corner, 0.99999, 1.0); }
"""
)
SKY_FRAGMENT = (
    COMMON
    + LIGHT
    + """
uniform mat4 back_projection;
in vec2 corner; out vec4 pixel;
void main() {
    vec4 far = back_projection * vec4(corner, 1.0, 1.0);
    vec3 d = normalize(far.xyz / far.w - eye);
    float disc = 2.0 * smoothstep(0.9994, 0.9998, dot(d, sun));
    pixel = tone(sky_colour(d.z < 0.0 ? vec3(d.xy, 0.0) : d) + disc * vec3(1.0, 0.85, 0.6));
}
"""
)
DEPTH_FRAGMENT = "void main() {}\n"
