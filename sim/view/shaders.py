"""Shaders: one light, one shadow map, one fog for everything."""

COMMON = """
#version 330
uniform mat4 view_projection;
uniform mat4 sun_projection;
uniform vec3 eye;
uniform vec3 sun;
uniform float time;
"""

LIGHT = """
uniform sampler2D shadow_map;
uniform float shadows;
vec3 sky_colour(vec3 d) {
    float h = clamp(d.z, 0.0, 1.0);
    vec3 sky = mix(vec3(0.86, 0.90, 0.92), vec3(0.36, 0.58, 0.85), pow(h, 0.55));
    float glow = max(dot(normalize(d), sun), 0.0);
    return sky + vec3(1.0, 0.85, 0.6) * (0.18 * pow(glow, 8.0) + 2.0 * smoothstep(0.9994, 0.9998, glow));
}
float lit(vec3 p, float facing) {
    if (shadows < 0.5) return 1.0;
    vec4 q = sun_projection * vec4(p, 1.0);
    vec3 s = q.xyz * 0.5 + 0.5;
    if (any(lessThan(s, vec3(0.0))) || any(greaterThan(s, vec3(1.0)))) return 1.0;
    float bias = 0.0006 + 0.0015 * (1.0 - facing);
    float texel = 1.0 / float(textureSize(shadow_map, 0).x);
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 o = vec2(float(i % 2) - 0.5, float(i / 2) - 0.5) * texel * 1.5;
        sum += texture(shadow_map, s.xy + o).r > s.z - bias ? 1.0 : 0.0;
    }
    return sum / 4.0;
}
vec3 shade(vec3 colour, vec3 p, vec3 n) {
    float facing = max(dot(n, sun), 0.0);
    float light = facing > 0.0 ? facing * lit(p, facing) : 0.0;
    vec3 ambient = mix(vec3(0.34, 0.31, 0.27), vec3(0.56, 0.63, 0.72), n.z * 0.5 + 0.5);
    vec3 view = normalize(eye - p);
    float rim = pow(1.0 - max(dot(n, view), 0.0), 3.0) * 0.12;
    vec3 c = colour * (ambient + light * vec3(0.86, 0.78, 0.62)) + rim * vec3(0.7, 0.8, 0.9);
    float fog = 1.0 - exp(-pow(length(eye - p) / 75.0, 1.6));
    return mix(c, sky_colour(normalize(p - eye) * vec3(1.0, 1.0, 0.2)), fog);
}
vec4 tone(vec3 c) { return vec4(pow(clamp(c, 0.0, 1.0), vec3(0.92)), 1.0); }
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
uniform vec4 focus;                     // place and radius that trees give the eye a way to; radius 0: they do not
void main() {
    if (focus.w > 0.0) {
        vec3 way = focus.xyz - eye;
        float t = dot(p - eye, way) / dot(way, way);
        float off = length(p - eye - t * way) / (focus.w * (0.35 + 0.65 * clamp(t, 0.0, 1.0)));
        float grain = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));
        if (t < 0.97 && off < 0.75 + 0.5 * grain) discard;
    }
    pixel = tone(shade(colour, p, normalize(n))); }
"""
)

CAPSULE_VERTEX = (
    COMMON
    + """
in vec4 in_shape;                       // unit direction, share of the way from a to b
in vec4 a; in vec4 b; in vec4 paint;    // ends with radii; colour and glow
out vec3 p; out vec3 n; out vec4 colour;
void main() {
    vec3 axis = b.xyz - a.xyz;
    float len = length(axis);
    vec3 w = len > 1e-6 ? axis / len : vec3(0.0, 0.0, 1.0);
    vec3 u = normalize(cross(w, abs(w.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
    vec3 v = cross(w, u);
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
    pixel = tone(d.z < 0.0 ? sky_colour(vec3(d.xy, 0.0)) : sky_colour(d));
}
"""
)
DEPTH_FRAGMENT = "#version 330\nvoid main() {}\n"
