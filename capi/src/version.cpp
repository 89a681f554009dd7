#include "palpate/palpate.h"

#define PLP_TEXT_OF(number) #number
#define PLP_TEXT(number) PLP_TEXT_OF(number)

uint32_t plp_version(void) {
  return PLP_VERSION_MAJOR * 1'000'000 + PLP_VERSION_MINOR * 1'000 + PLP_VERSION_PATCH;
}

const char* plp_version_string(void) {
  return PLP_TEXT(PLP_VERSION_MAJOR) "." PLP_TEXT(PLP_VERSION_MINOR) "." PLP_TEXT(PLP_VERSION_PATCH);
}
