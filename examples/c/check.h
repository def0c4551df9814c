/* What every example does with a failure: say it and stop. */
#ifndef EXAMPLES_CHECK_H
#define EXAMPLES_CHECK_H

#include <alphamst/alphamst.h>
#include <stdio.h>
#include <stdlib.h>

static void check(amst_status status) {
    if (status < 0) {
        fprintf(stderr, "%s: %s\n", amst_status_name(status), amst_last_error());
        exit(1);
    }
}

#endif
