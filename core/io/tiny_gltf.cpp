#include <fstream>  // tinygltf needs it even without files

#define TINYGLTF_IMPLEMENTATION
#include "io/tiny_gltf.h"
