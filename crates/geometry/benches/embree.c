// Times Embree 4 for the bench `traversal`, which compiles and runs this; needs no headers.
// Arguments: a file of corners of triangles, one of origins and directions, all in single precision;
// 1 for occlusion within the length of the direction or 0 for first hits; the rays in a batch.
// Prints for each batch the seconds it took, and how many rays found something.
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

typedef struct { float origin[3], near, direction[3], time, far; unsigned mask, id, flags; } Ray;
typedef struct { Ray ray; float normal[3], u, v; unsigned face, geometry, instances[5]; } Hit;

void *rtcNewDevice(const char *options);
void *rtcNewScene(void *device);
void *rtcNewGeometry(void *device, int type);
void *rtcSetNewGeometryBuffer(void *, int type, int slot, int format, size_t stride, size_t count);
void rtcSetGeometryBuildQuality(void *geometry, int quality);
void rtcSetSceneBuildQuality(void *scene, int quality);
void rtcCommitGeometry(void *geometry);
void rtcAttachGeometry(void *scene, void *geometry);
void rtcCommitScene(void *scene);
void rtcIntersect1(void *scene, Hit *hit, void *options);
void rtcOccluded1(void *scene, Ray *ray, void *options);

// As many numbers as the file has.
static size_t size(FILE *file) {
    fseek(file, 0, SEEK_END);
    size_t bytes = ftell(file);
    rewind(file);
    return bytes / sizeof(float);
}

int main(int count, char **arguments) {
    FILE *corners = fopen(arguments[1], "rb"), *rays = fopen(arguments[2], "rb");
    int occlusion = atoi(arguments[3]), batch = atoi(arguments[4]);
    size_t corner_size = size(corners), ray_size = size(rays);
    void *device = rtcNewDevice(0), *scene = rtcNewScene(device), *mesh = rtcNewGeometry(device, 0);
    float *into = rtcSetNewGeometryBuffer(mesh, 1, 0, 0x9003, 12, corner_size / 3);
    unsigned *faces = rtcSetNewGeometryBuffer(mesh, 0, 0, 0x5003, 12, corner_size / 9);
    for (unsigned i = 0; i < corner_size / 3; i++) faces[i] = i;
    float(*from)[6] = malloc(ray_size * sizeof(float));
    if (fread(into, sizeof(float), corner_size, corners) != corner_size) return 1;
    if (fread(from, sizeof(float), ray_size, rays) != ray_size) return 1;
    rtcSetGeometryBuildQuality(mesh, 2); // the best: with triangles split
    rtcSetSceneBuildQuality(scene, 2);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene, mesh);
    rtcCommitScene(scene);
    for (size_t next = 0, end = ray_size / 6; next < end;) {
        size_t found = 0, stop = next + batch < end ? next + batch : end;
        struct timespec start, now;
        clock_gettime(CLOCK_MONOTONIC, &start);
        for (; next < stop; next++) {
            float *o = from[next], *d = o + 3, far = occlusion ? 1 : 1e30f;
            Ray ray = {{o[0], o[1], o[2]}, 0, {d[0], d[1], d[2]}, 0, far, -1};
            __attribute__((aligned(16))) Hit hit = {.ray = ray, .geometry = -1, .instances = {-1}};
            if (occlusion) rtcOccluded1(scene, &hit.ray, 0);
            else rtcIntersect1(scene, &hit, 0);
            found += occlusion ? hit.ray.far < 0 : hit.geometry != -1u;
        }
        clock_gettime(CLOCK_MONOTONIC, &now);
        printf("%.9f %zu\n", now.tv_sec - start.tv_sec + 1e-9 * (now.tv_nsec - start.tv_nsec), found);
    }
}
