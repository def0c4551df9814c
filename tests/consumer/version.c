#include <alphamst/alphamst.h>
#include <stdio.h>

int main(void) {
    int expected = AMST_VERSION_MAJOR * 10000 + AMST_VERSION_MINOR * 100 + AMST_VERSION_PATCH;
    printf("AlphaMST %s\n", amst_version_string());
    return amst_version() == expected ? 0 : 1;
}
