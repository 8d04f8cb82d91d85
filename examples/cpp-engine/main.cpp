// The emitted GLSL in a C++ program, by both roads: as the text of a shader, and as functions on the CPU.
#include "glsl.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

// The text, for glShaderSource or a compiler to SPIR-V. run.sh puts the marks of a raw string around the file.
constexpr char film_glsl[] =
#include "generated/bubble.450.glsl.inc"
    ;

// The same file as C++.
namespace film {
using namespace glsl;
#include "generated/bubble.450.glsl"
}  // namespace film

// A complete fragment shader around the text.
static std::string fragment_shader() {
    return std::string("#version 450\n") + film_glsl + R"glsl(
layout(location = 0) in vec2 cosine_and_thickness;
layout(location = 0) out vec4 fragment_color;
void main() {
    fragment_color = vec4(surface_reflectance(cosine_and_thickness.x, cosine_and_thickness.y), 1.0);
}
)glsl";
}

// Compares the functions with the values that pavo has written beside them.
static int check(const char* path) {
    constexpr float largest_allowed = 1e-5f;
    std::ifstream file(path);
    std::string line;
    float largest = 0.0f;
    int points = 0;
    while (std::getline(file, line)) {
        float cos_theta1, thickness_nm, r, g, b;
        if (std::sscanf(line.c_str(), "%f,%f,%f,%f,%f", &cos_theta1, &thickness_nm, &r, &g, &b) != 5) continue;
        const glsl::vec3 found = film::surface_reflectance(cos_theta1, thickness_nm);
        for (const float difference : {found.x - r, found.y - g, found.z - b}) {
            // What is no number is as far off as can be.
            largest = std::isnan(difference) ? INFINITY : std::max(largest, std::fabs(difference));
        }
        ++points;
    }
    std::printf("%d points of %s: at most %.1e apart (allowed: %.0e)\n", points, path, largest, largest_allowed);
    return points > 0 && largest <= largest_allowed ? 0 : 1;
}

int main(int count, char** arguments) {
    if (count == 2 && std::strcmp(arguments[1], "--shader") == 0) {
        std::fputs(fragment_shader().c_str(), stdout);
        return 0;
    }
    if (count == 2) return check(arguments[1]);
    std::fprintf(stderr, "Usage: engine TEST_VECTORS.csv    compares the functions with these values\n"
                         "       engine --shader            prints the fragment shader\n");
    return 2;
}
