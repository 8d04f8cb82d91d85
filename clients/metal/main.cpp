// Evaluates the function of an export for Metal at points from standard input: six numbers each.
#include "PavoThinFilm.h"

#include <cstdio>

int main() {
    float point[6];
    for (;;) {
        for (float& number : point) {
            if (std::scanf("%f", &number) != 1) return 0;
        }
        metal::float3 color(point[3], point[4], point[5]);
        metal::float3 found = pavoThinFilm(point[0], point[1], point[2], 1.0f, 1.0f, 0.0f, color, 1.0f);
        std::printf("%.9g %.9g %.9g\n", found.x, found.y, found.z);
    }
}
