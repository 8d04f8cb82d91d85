// What emitted GLSL needs of C++: the type vec3 and the built-in functions, for use on the CPU.
#pragma once
#include <algorithm>
#include <cmath>

namespace glsl {

struct vec3 {
    float x, y, z;
    constexpr vec3(float x, float y, float z) : x(x), y(y), z(z) {}
    explicit constexpr vec3(float all) : vec3(all, all, all) {}
    vec3& operator+=(vec3 b) { return *this = vec3(x + b.x, y + b.y, z + b.z); }
    vec3& operator-=(vec3 b) { return *this = vec3(x - b.x, y - b.y, z - b.z); }
    vec3& operator*=(vec3 b) { return *this = vec3(x * b.x, y * b.y, z * b.z); }
    vec3& operator/=(vec3 b) { return *this = vec3(x / b.x, y / b.y, z / b.z); }
    vec3& operator*=(float b) { return *this *= vec3(b); }
    vec3& operator/=(float b) { return *this /= vec3(b); }
};

inline vec3 operator-(vec3 a) { return vec3(-a.x, -a.y, -a.z); }
inline vec3 operator+(vec3 a, vec3 b) { return a += b; }
inline vec3 operator-(vec3 a, vec3 b) { return a -= b; }
inline vec3 operator*(vec3 a, vec3 b) { return a *= b; }
inline vec3 operator/(vec3 a, vec3 b) { return a /= b; }
inline vec3 operator+(vec3 a, float b) { return a + vec3(b); }
inline vec3 operator+(float a, vec3 b) { return vec3(a) + b; }
inline vec3 operator-(vec3 a, float b) { return a - vec3(b); }
inline vec3 operator-(float a, vec3 b) { return vec3(a) - b; }
inline vec3 operator*(vec3 a, float b) { return a * vec3(b); }
inline vec3 operator*(float a, vec3 b) { return vec3(a) * b; }
inline vec3 operator/(vec3 a, float b) { return a / vec3(b); }
inline vec3 operator/(float a, vec3 b) { return vec3(a) / b; }

inline float sqrt(float x) { return std::sqrt(x); }
inline float inversesqrt(float x) { return 1.0f / std::sqrt(x); }
inline float sin(float x) { return std::sin(x); }
inline float cos(float x) { return std::cos(x); }
inline float exp(float x) { return std::exp(x); }
inline float abs(float x) { return std::fabs(x); }
inline float max(float x, float y) { return std::max(x, y); }
inline float min(float x, float y) { return std::min(x, y); }
inline float clamp(float x, float low, float high) { return std::clamp(x, low, high); }
inline vec3 sqrt(vec3 v) { return vec3(sqrt(v.x), sqrt(v.y), sqrt(v.z)); }
inline vec3 sin(vec3 v) { return vec3(sin(v.x), sin(v.y), sin(v.z)); }
inline vec3 cos(vec3 v) { return vec3(cos(v.x), cos(v.y), cos(v.z)); }
inline vec3 exp(vec3 v) { return vec3(exp(v.x), exp(v.y), exp(v.z)); }
inline vec3 max(vec3 v, vec3 w) { return vec3(max(v.x, w.x), max(v.y, w.y), max(v.z, w.z)); }
inline vec3 max(vec3 v, float low) { return max(v, vec3(low)); }
inline float dot(vec3 v, vec3 w) { return v.x * w.x + v.y * w.y + v.z * w.z; }
inline vec3 normalize(vec3 v) { return v * inversesqrt(dot(v, v)); }

}  // namespace glsl
