/* alphamst.h - quadrilateral mesh adaptation, C interface.
 *
 * One parameter, alpha, asks for improvement (alpha = 1), refinement
 * (alpha > 1) or simplification (alpha < 1) of patches of a quad mesh; alpha
 * is the wanted ratio of face counts, new / old.
 *
 * Rules that hold for every function, stated once:
 *
 *  Status     Fallible calls return amst_status: 0 success, > 0 success with a
 *             remark, < 0 failure. After a failure every handle passed in is as
 *             it was before the call and no output argument has been written,
 *             except a `needed` count. amst_last_error() has the words. A compiler that
 *             knows how (GCC, Clang) warns where the status is not looked at.
 *  Ownership  A handle written through `T **out` belongs to the caller, who ends
 *             it with the matching _destroy; NULL is accepted there. Handles may
 *             be destroyed in any order and from any thread: a child keeps what
 *             it needs of its parent alive. The library never keeps a pointer to
 *             caller memory after it returns, callbacks excepted.
 *  NULL       gives AMST_ERR_NULL, except where it is said to be allowed, for
 *             destroy calls, and for an array of no elements.
 *  Arrays     Inputs are read in the call. Outputs follow one pattern:
 *             (T *out, int64_t capacity, int64_t *needed). `needed` receives the
 *             number of T the answer has and may not be NULL; out = NULL with
 *             capacity = 0 only asks. A capacity that is too small gives
 *             AMST_ERR_BUFFER_TOO_SMALL and writes nothing but `needed`.
 *             Rows are packed, last index fastest in C: points[n][dim],
 *             faces[n][4]; in Fortran and Julia points(dim,n), faces(4,n).
 *  Ids        Vertices, edges, faces and patches are numbered without gaps from
 *             the context's index base (0 or 1); "none" is base - 1. Ids are
 *             valid for one mesh revision. Faces list corners counter-clockwise.
 *  Units      Lengths are in the unit of the given coordinates, angles in degrees. No coordinate
 *             may be beyond 1e30, and no mesh smaller than 1e-30, unless all of it is at one place:
 *             AMST_ERR_RANGE.
 *  Threads    Calls that take only const handles may run at the same time. A call
 *             that takes a non-const handle needs it to itself, and its mesh if it
 *             is a patch set; one context serves one thread at a time. Different
 *             contexts share nothing: threads of the caller, as of an OpenMP region, have
 *             one each, and meshes by amst_mesh_clone_into. Callbacks run on the calling thread only; they
 *             may ask and may destroy, but a call that would change something of the
 *             same context gives AMST_ERR_STATE.
 *  Same again Equal input, options and seed give equal output for any thread count.
 *  C++        No exception leaves the library; none may enter it from a callback.
 */
#ifndef ALPHAMST_ALPHAMST_H
#define ALPHAMST_ALPHAMST_H

#include <stdint.h>

#define AMST_VERSION_MAJOR 0
#define AMST_VERSION_MINOR 1
#define AMST_VERSION_PATCH 0

#if defined(AMST_STATIC)
#define AMST_API
#elif defined(_WIN32)
#if defined(AMST_BUILD)
#define AMST_API __declspec(dllexport)
#else
#define AMST_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define AMST_API __attribute__((visibility("default")))
#else
#define AMST_API
#endif

/* What can fail: compilers warn where the status is not looked at. */
#if defined(__GNUC__)
#define AMST_TRY AMST_API __attribute__((warn_unused_result))
#else
#define AMST_TRY AMST_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------ types */

typedef int32_t amst_status; /* an amst_status_code */
typedef int32_t amst_id;     /* number of a vertex, edge, face or patch */

typedef struct amst_context amst_context; /* threads, callbacks, index base */
typedef struct amst_options amst_options; /* numeric settings, all with defaults */
typedef struct amst_mesh amst_mesh;       /* quad mesh with flags, fields, savepoints */
typedef struct amst_patches amst_patches; /* disjoint face regions of one mesh */
typedef struct amst_report amst_report;   /* what one operation did */

/* Enumerations travel as int32_t. The negative member keeps the type signed on
 * every compiler, the largest one keeps it 32 bits wide. */
enum amst_status_code {
    AMST_ERR_INTERNAL = -99, /* a bug in the library */
    AMST_ERR_STATE = -16,    /* call not allowed now, e.g. from a callback */
    AMST_ERR_NO_MEMORY = -15,
    AMST_ERR_CANCELLED = -14,   /* cancelled; mesh as before the call */
    AMST_ERR_UNSUPPORTED = -13, /* file variant: not in this version */
    AMST_ERR_FORMAT = -12,      /* file is malformed */
    AMST_ERR_IO = -11,          /* file cannot be opened, read or written */
    AMST_ERR_NOT_FOUND = -10,   /* no such key, revision or field */
    AMST_ERR_STALE = -9,        /* patches or report of an older revision */
    AMST_ERR_PATCH = -8,        /* patch is not a usable disk, see defects */
    AMST_ERR_NO_FILLING = -17,  /* no filling with the wanted faces was found; patch as before */
    AMST_ERR_GEOMETRY = -18,    /* no filling could be given a valid shape; patch as before */
    AMST_ERR_PROJECTION = -20,  /* the projection of the boundary failed; mesh as before the call */
    AMST_ERR_CHORD = -19,       /* chord cannot be collapsed or split, see amst_refusal */
    AMST_ERR_NOT_MANIFOLD = -7, /* edge of 3+ faces, one side only, or faces that meet in a vertex alone */
    AMST_ERR_NOT_QUAD = -6,     /* face without 3 or 4 distinct corners */
    AMST_ERR_NOT_FINITE = -5,   /* NaN or infinity in the input */
    AMST_ERR_BUFFER_TOO_SMALL = -4,
    AMST_ERR_RANGE = -3,    /* id, count or value out of range */
    AMST_ERR_ARGUMENT = -2, /* other unacceptable argument */
    AMST_ERR_NULL = -1,     /* required pointer is NULL */
    AMST_OK = 0,
    AMST_PARTIAL = 1, /* done, but some patch was left or missed alpha, or a marker of a file was left out */
    AMST_STATUS_MAX = 0x7fffffff
};

enum amst_entity {
    AMST_ENTITY_NONE = -1,
    AMST_VERTEX = 0,
    AMST_EDGE = 1,
    AMST_FACE = 2,
    AMST_ENTITY_MAX = 0x7fffffff
};

/* Bits; combine with |. */
enum amst_flag {
    AMST_FLAG_INVALID = -1,
    AMST_FLAG_FIXED = 1,   /* entity is neither moved, split nor removed */
    AMST_FLAG_FEATURE = 2, /* on a curve that must survive; may slide along it */
    AMST_FLAG_CORNER = 4,  /* end or crossing of such curves; does not move */
    AMST_FLAG_MAX = 0x7fffffff
};

/* How a field follows the mesh through an operation, see amst_mesh_set_field. */
enum amst_carry {
    AMST_CARRY_INVALID = -1,
    AMST_CARRY_DROP = 0,     /* removed when connectivity changes */
    AMST_CARRY_INHERIT = 1,  /* value of the nearest entity that was replaced */
    AMST_CARRY_LINEAR = 2,   /* interpolated linearly; vertices */
    AMST_CARRY_CONSERVE = 3, /* integral kept, linear on each face before; faces, vertices */
    AMST_CARRY_AVERAGE = 4,  /* integral kept, constant on each face before; faces, vertices */
    AMST_CARRY_MAX = 0x7fffffff
};

/* Bits reported by amst_patches_check. */
enum amst_defect {
    AMST_DEFECT_INVALID = -1,
    AMST_DEFECT_EMPTY = 1,
    AMST_DEFECT_NOT_CONNECTED = 2,
    AMST_DEFECT_NOT_DISK = 4,         /* Euler characteristic is not 1 */
    AMST_DEFECT_PINCHED = 8,          /* boundary touches itself */
    AMST_DEFECT_OVERLAP = 16,         /* shares a face with an earlier patch */
    AMST_DEFECT_CROSSES_FEATURE = 32, /* flagged entity or region border in the interior */
    AMST_DEFECT_ODD_BOUNDARY = 64,    /* odd number of boundary edges */
    AMST_DEFECT_CORNERS = 128,        /* given corners not on the boundary, or not in its order */
    AMST_DEFECT_NOT_CONVEX = 256,     /* remark only: convexity below the option */
    AMST_DEFECT_MAX = 0x7fffffff
};

/* What is told of a chord by amst_mesh_get_chords. */
enum amst_chord_property {
    AMST_CHORD_INVALID = -1,
    AMST_CHORD_EDGE = 0,           /* its smallest edge */
    AMST_CHORD_CLOSED = 1,         /* 1: cyclic, 0: from boundary to boundary */
    AMST_CHORD_LENGTH = 2,         /* faces it passes, those passed twice counted twice */
    AMST_CHORD_FACES = 3,          /* the same, counted once */
    AMST_CHORD_CROSSINGS = 4,      /* faces where it crosses itself */
    AMST_CHORD_TOUCHES = 5,        /* vertices at more than one of its edges */
    AMST_CHORD_SINGULARITIES = 6,  /* singular vertices at its edges */
    AMST_CHORD_REFUSAL = 7,        /* amst_refusal bits of its collapse, 0: it can be collapsed */
    AMST_CHORD_SINGULAR_AFTER = 8, /* singular vertices of the mesh once it is; now if it cannot be */
    AMST_CHORD_MAX = 0x7fffffff
};

/* Why a chord cannot be collapsed, bits. */
enum amst_refusal {
    AMST_REFUSAL_INVALID = -1,
    AMST_REFUSAL_CROSSING = 1, /* crosses itself: a face would become a point */
    AMST_REFUSAL_CLOSED = 2,   /* its borders meet: no surface would be left between them */
    AMST_REFUSAL_BOUNDARY = 4, /* it would join boundary vertices or, not allowed, change the boundary */
    AMST_REFUSAL_FIXED = 8,    /* a FIXED entity would go or move */
    AMST_REFUSAL_FEATURE = 16, /* two features, or two corners of one, would be merged */
    AMST_REFUSAL_VALENCE = 32, /* a vertex would get a valence below 3 (a doublet) or above 6 */
    AMST_REFUSAL_DOUBLE = 64,  /* two edges would have the same vertices, or a face one twice */
    AMST_REFUSAL_MAX = 0x7fffffff
};

enum amst_decomposition {
    AMST_DECOMPOSE_INVALID = -1,
    AMST_DECOMPOSE_CLUSTERS = 0,      /* compact face clusters (Lloyd) */
    AMST_DECOMPOSE_PARTITION = 1,     /* balanced graph partition */
    AMST_DECOMPOSE_VORONOI = 2,       /* geodesic Voronoi cells of faces far from one another */
    AMST_DECOMPOSE_MEDIAL = 3,        /* discs: faces within the largest inscribed circles */
    AMST_DECOMPOSE_SINGULARITIES = 4, /* faces around singular vertices that lie together */
    AMST_DECOMPOSE_MAX = 0x7fffffff
};

/* What amst_mesh_get_geometry tells. */
enum amst_geometry {
    AMST_GEOMETRY_INVALID = -1,
    AMST_GEOMETRY_CENTROIDS = 0, /* [n_faces][dim], of what the face covers */
    AMST_GEOMETRY_LENGTHS = 1,   /* [n_edges] */
    AMST_GEOMETRY_NORMALS = 2,   /* [n_edges][dim], of length 1, at right angles to the edge, out of the first
                                    face of amst_mesh_get_edge_faces: so on the boundary outwards. On curved
                                    meshes also at right angles to the mean normal of its faces. 0 for an edge
                                    or faces without extent */
    AMST_GEOMETRY_MAX = 0x7fffffff
};

/* Verdict quadrilateral metrics. */
enum amst_metric {
    AMST_METRIC_INVALID = -1,
    AMST_METRIC_AREA = 0,
    AMST_METRIC_ASPECT_RATIO = 1,
    AMST_METRIC_CONDITION = 2,
    AMST_METRIC_DISTORTION = 3,
    AMST_METRIC_EDGE_RATIO = 4,
    AMST_METRIC_JACOBIAN = 5,
    AMST_METRIC_MAX_ANGLE = 6,
    AMST_METRIC_MIN_ANGLE = 7,
    AMST_METRIC_ODDY = 8,
    AMST_METRIC_RADIUS_RATIO = 9,
    AMST_METRIC_RELATIVE_SIZE = 10,
    AMST_METRIC_SCALED_JACOBIAN = 11,
    AMST_METRIC_SHAPE = 12,
    AMST_METRIC_SHAPE_AND_SIZE = 13,
    AMST_METRIC_SHEAR = 14,
    AMST_METRIC_SHEAR_AND_SIZE = 15,
    AMST_METRIC_SKEW = 16,
    AMST_METRIC_STRETCH = 17,
    AMST_METRIC_TAPER = 18,
    AMST_METRIC_WARPAGE = 19,
    AMST_METRIC_MAX = 0x7fffffff
};

/* Keys of amst_options_set_int (< 1000) and _set_real (>= 1000). */
enum amst_option {
    AMST_OPTION_INVALID = -1,
    AMST_OPT_SEED = 0,             /* int, 0: seed of every random choice */
    AMST_OPT_SMOOTH_STEPS = 1,     /* int, 20: sweeps of shape optimisation, 0..1000 */
    AMST_OPT_REPAIR_PATCHES = 2,   /* int 0/1, 1: fill small holes, cut pinches of new patches */
    AMST_OPT_CANDIDATES = 3,       /* int, 16: fillings to try in a patch before it is left, 1..1000 */
    AMST_OPT_NODE_LIMIT = 4,       /* int, 1000: effort of one exact search, in quads laid, 0..10^9 */
    AMST_OPT_QUADRANGULATE = 5,    /* int, 0: triangles 0 are paired, 1 every face is split */
    AMST_OPT_EDIT_BOUNDARY = 6,    /* int 0/1, 0: vertices may come and go on the boundary */
    AMST_OPT_STRATEGY = 7,         /* int, 0: amst_adapt of a whole mesh by windows, 1 by chords alone */
    AMST_OPT_ALIGN = 8,            /* int 0/1, 0: edges of curved meshes follow their cross field */
    AMST_OPT_CHART = 9,            /* int, 0: maps what is curved; 1 mean value, 2 conformal, 3 low stretch */
    AMST_OPT_KEEP_BOUNDARY = 10,   /* int 0/1, 0: new meshes get no vertex on the boundary, or fail */
    AMST_OPT_STARTS = 11,          /* int, 1: searches of a whole mesh, the best is kept, 1..1000 */
    AMST_OPT_BUFFER_LAYERS = 12,   /* int, 2: layers of faces around each that get its "size", 0..1000 */
    AMST_OPT_MIN_QUALITY = 1000,   /* real, 0.0: no filling with a scaled Jacobian at or below, 0..1 */
    AMST_OPT_MIN_CONVEXITY = 1001, /* real, 0.6: below is AMST_DEFECT_NOT_CONVEX, 0..1 */
    AMST_OPT_PATCH_FACES = 1002,   /* real, 100: aim of automatic decomposition, >= 1 */
    AMST_OPT_TOLERANCE = 1003,     /* real, 0.5: farthest from surface, boundary, in wanted edges, .01..100 */
    AMST_OPT_EFFORT = 1004,        /* real, 1.0: times as much is spent on better fillings, 0.01..100 */
    AMST_OPT_SIZE_WEIGHT = 1005,   /* real, 0.7: of wanted sizes against shapes, 0..1 */
    AMST_OPT_TRANSITION = 1006,    /* real, 0.5: of a patch's depth, over which sizes change, 0.05..1 */
    AMST_OPT_LEAST_SIZE = 1007,    /* real, 0.125: area over wanted area; no smaller face is made, 0..1 */
    AMST_OPT_SHARP_ANGLE = 1008,   /* real, 40.0: degrees; no pair of triangles over a sharper edge, 0..180 */
    AMST_OPT_SIZE_BAND = 1009,     /* real, 0.0: log2 of area; plane faces off "size" by less stay, 0..8 */
    AMST_OPT_MIN_EDGE = 1010,      /* real, 0.0: least "size" of an indicator, in units of length, 0..1e30 */
    AMST_OPT_MAX_EDGE = 1011,      /* real, 0.0: largest one, 0..1e30; 0: the extent of the mesh */
    AMST_OPT_GRADATION = 1012,     /* real, 0.2: growth of "size" over the length it grows in, 0.01..100 */
    AMST_OPT_ERROR_ORDER = 1013,   /* real, 1.0: power of the edge length that an indicator is like, .1..16 */
    AMST_OPTION_MAX = 0x7fffffff
};

/* Keys of amst_report_get_int (< 1000) and amst_report_get_real (>= 1000). The
 * singularities of a patch are the singular vertices of the mesh in it, its
 * boundary included; those of AMST_ALL are the ones of the whole mesh.
 *
 * Sizes, aspect ratio and time step are those of the faces of the patch. The area that amst_adapt and
 * amst_reduce_singularities want there is the area that was there (smoothed), or the
 * square of the field "size": at the border as it is, inside that over a factor, so that the count is
 * reached; in between it changes as AMST_OPT_TRANSITION says. AMST_ALL: the size error is the root mean
 * square over the faces of all patches, the least area and the shortest edge the smallest, the aspect ratio
 * the largest, the time step that of the whole mesh. Without patches the wanted area is the square of the
 * field "size", or else in a plane the area that was there (smoothed), on a surface what its curvature asks
 * for; all times one factor, so that the mesh as it was comes to the wanted count. The other operations, and
 * AMST_OPT_STRATEGY 1, want no sizes. A patch that is left has after = before and the time step 1. */
enum amst_result {
    AMST_RESULT_INVALID = -1,
    AMST_RESULT_STATUS = 0, /* amst_status of the patch; of AMST_ALL: of the call */
    AMST_RESULT_FACES_BEFORE = 1,
    AMST_RESULT_FACES_AFTER = 2,
    AMST_RESULT_FACES_WANTED = 3,    /* alpha * before, rounded; but see AMST_OPT_SIZE_BAND */
    AMST_RESULT_SINGULAR_BEFORE = 4, /* interior vertices of valence != 4 */
    AMST_RESULT_SINGULAR_AFTER = 5,
    AMST_RESULT_SINGULAR_BOUND = 6, /* least number that any filling of the boundary has */
    AMST_RESULT_CANDIDATE = 7,      /* 0: the filling that promised most; n: geometry forced the n-th later */
    AMST_RESULT_UNUSED_OPTION = 8,  /* AMST_ALL: key of the first option set in vain, -1: none */
    AMST_RESULT_ALPHA = 1000,       /* after / before */
    AMST_RESULT_QUALITY_BEFORE = 1001, /* smallest scaled Jacobian */
    AMST_RESULT_QUALITY_AFTER = 1002,
    AMST_RESULT_SECONDS = 1003,
    AMST_RESULT_SIZE_ERROR_BEFORE = 1004, /* rms of log2(area / wanted area); NaN: no sizes were wanted */
    AMST_RESULT_SIZE_ERROR_AFTER = 1005,
    AMST_RESULT_LEAST_AREA_BEFORE = 1006, /* smallest area / wanted area; NaN likewise */
    AMST_RESULT_LEAST_AREA_AFTER = 1007,
    AMST_RESULT_TIME_STEP = 1008,            /* smallest area / perimeter of a face, after over before */
    AMST_RESULT_SHORTEST_EDGE_BEFORE = 1009, /* smallest edge / root of the area wanted there; NaN likewise */
    AMST_RESULT_SHORTEST_EDGE_AFTER = 1010,
    AMST_RESULT_ASPECT_RATIO_BEFORE = 1011, /* largest AMST_METRIC_ASPECT_RATIO */
    AMST_RESULT_ASPECT_RATIO_AFTER = 1012,
    AMST_RESULT_AREA_GAINED = 1013, /* area after - before; 0 where AMST_OPT_EDIT_BOUNDARY is not set */
    AMST_RESULT_MAX = 0x7fffffff
};

enum amst_log_level {
    AMST_LOG_OFF = -1,
    AMST_LOG_ERROR = 0,
    AMST_LOG_WARNING = 1, /* patches that were left or missed their count, and why; options
                             without effect; sharp edges within quads of new meshes, and their
                             boundary edges that got a vertex; markers that a file has and the mesh cannot
                             have, or the other way round */
    AMST_LOG_INFO = 2,    /* one line a stage, and what the operation came to */
    AMST_LOG_DEBUG = 3,   /* one line a cavity (patch or window): where, how large, how many candidates, why
                             those that were refused were, what was taken */
    AMST_LOG_MAX = 0x7fffffff
};

enum amst_scope {
    AMST_ALL = -2, /* in place of a patch id: all patches together */
    AMST_SCOPE_MAX = 0x7fffffff
};

/* The only struct of the interface; its 48 bytes never change. */
typedef struct amst_summary {
    int64_t count;      /* faces measured */
    int64_t acceptable; /* faces inside the metric's acceptable range */
    double min;
    double max;
    double mean;
    double stddev;
} amst_summary;

/* fraction is 0..1, stage a static English word; long stages tell the same fraction again. Return non-zero to
 * cancel. */
typedef int32_t (*amst_progress_fn)(void *user, double fraction, const char *stage);
/* message is valid during the call only. */
typedef void (*amst_log_fn)(void *user, int32_t level, const char *message);
/* Writes to projected [n][dim] the points of the boundary that belong to points [n][dim], which
 * are near it; marker [n] of the edge at each. 0: done; else the call under way fails. */
typedef int32_t (*amst_projection_fn)(void *user, int64_t n, const int32_t *marker, const double *points,
                                      double *projected);

/* ------------------------------------------------------- library and errors */

/* major * 10000 + minor * 100 + patch of the library in use. */
AMST_API int32_t amst_version(void);
AMST_API const char *amst_version_string(void);
/* 1 if the build has the named feature ("threads"), else 0. */
AMST_API int32_t amst_has(const char *feature);
/* Name of a status, e.g. "AMST_ERR_STALE"; never NULL. */
AMST_API const char *amst_status_name(amst_status status);
/* Sentence about the last failure on this thread, or about what the last call that gave
 * AMST_PARTIAL could not do and why; "" if there was none. Valid until the next such call
 * on this thread; destroy calls do not touch it. */
AMST_API const char *amst_last_error(void);
/* Where it happened: AMST_ENTITY_NONE if it is not about one entity; patch is
 * "none" if it is not about one patch. Any output may be NULL. */
AMST_TRY amst_status amst_last_error_where(int32_t *entity, amst_id *id, amst_id *patch);

/* ------------------------------------------------------------------ context */

/* index_base 0 or 1: numbering of every id that crosses this interface.
 * Errors: ARGUMENT (index_base). */
AMST_TRY amst_status amst_context_create(int32_t index_base, amst_context **out);
AMST_API void amst_context_destroy(amst_context *ctx);
/* Threads of an operation: 0 all cores, n at most n; 1 at creation. Errors: RANGE (n < 0). */
AMST_TRY amst_status amst_context_set_threads(amst_context *ctx, int32_t n);
/* Messages up to a level of amst_log_level, and the progress of operations, go to
 * the caller's functions, which get `user` back. NULL fn switches off, which is the
 * state at creation: nothing is ever printed. Errors: ARGUMENT (level). */
AMST_TRY amst_status amst_context_set_log(amst_context *ctx, int32_t level, amst_log_fn fn, void *user);
AMST_TRY amst_status amst_context_set_progress(amst_context *ctx, amst_progress_fn fn, void *user);
/* The next two may be called from any thread while an operation runs. A raised
 * flag (not 0) stays up, and stops operations with AMST_ERR_CANCELLED, until it is
 * lowered (0). fraction: 0..1, of the operation under way or else of the last one. */
AMST_TRY amst_status amst_context_set_cancel(amst_context *ctx, int32_t flag);
AMST_TRY amst_status amst_context_get_progress(const amst_context *ctx, double *fraction);

/* ------------------------------------------------------------------ options */
/* Every `const amst_options *` argument may be NULL: all defaults. Which options count in an operation is in
 * the table of amst_adapt, or said at the function. One of that table, but for SEED and SMOOTH_STEPS, that is
 * not at its default and has no effect on the call is told by AMST_RESULT_UNUSED_OPTION and a line of
 * AMST_LOG_WARNING. */

AMST_TRY amst_status amst_options_create(amst_options **out);
AMST_API void amst_options_destroy(amst_options *options);
/* Errors: NOT_FOUND (a key of the other type or unknown to this version), RANGE
 * (value, see amst_option), NOT_FINITE. */
AMST_TRY amst_status amst_options_set_int(amst_options *options, int32_t key, int64_t value);
AMST_TRY amst_status amst_options_set_real(amst_options *options, int32_t key, double value);
AMST_TRY amst_status amst_options_get_int(const amst_options *options, int32_t key, int64_t *value);
AMST_TRY amst_status amst_options_get_real(const amst_options *options, int32_t key, double *value);
/* Edges that no pair of triangles crosses in amst_mesh_create and amst_mesh_read: edge e is between
 * vertices[2 * e] and vertices[2 * e + 1], ids of the mesh given, in the index base of its context. They take
 * the place of those set before; n_edges 0: none. An edge may get a vertex at its midpoint. In the new mesh
 * they are no features, unless amst_mesh_set_flags makes them some. Errors: NULL, RANGE (count). */
AMST_TRY amst_status amst_options_set_edges(amst_options *options, const amst_id *vertices, int64_t n_edges);
/* 2 elements an edge, as they were set. */
AMST_TRY amst_status amst_options_get_edges(const amst_options *options, amst_id *out, int64_t capacity,
                                            int64_t *needed);

/* --------------------------------------------------------------------- mesh */

/* Mesh from arrays. coords: component c of vertex v is
 * coords[v * vertex_stride + c * component_stride]; faces likewise with
 * face_stride and corner_stride, all in elements and above 0; both strides 0 means
 * packed. dim is 2 or 3. corners_per_face is 3, all triangles, or 4, where "none" as the
 * last corner makes a triangle. At least one face, at most 2^28 - 1. Unreferenced vertices
 * stay. If there are triangles, faces become quads as AMST_OPT_QUADRANGULATE says; all
 * given vertices keep their ids and coordinates, new ones come behind them:
 *  0  Triangles are merged in pairs along a common side, by quality: no quad is concave or flat where
 *     another pairing has none nearby. Pairs do not cross edges whose faces have normals more than
 *     AMST_OPT_SHARP_ANGLE apart, unless a flat side between such edges has an odd number of
 *     triangles; AMST_LOG_WARNING says which. They never cross those of amst_options_set_edges. Nothing is
 * sharp in a plane (equal z), nor on rough surfaces, such as scans, where angles beyond are as common as
 * those below. Four triangles that are a flat square become one quad; their vertex stays, without faces. The
 * boundary stays where a component has an even number of triangles; else a side on it gets a vertex at its
 * midpoint, which AMST_OPT_KEEP_BOUNDARY forbids. Triangles that are left over are brought together: quads
 *     between them are paired anew, or split in a row. A quad that is flat at a vertex on the
 *     boundary, a sharp edge or the border of a region becomes five. One triangle on its own is split
 *     as by 1, and so is a closed surface where nothing can be paired, such as a tetrahedron.
 *  1  Every edge gets a vertex at its midpoint and every face one inside: three quads of
 *     a triangle, four of a quad.
 * Faces that run another way round than their neighbours are turned over: in the plane (dim 2) components
 * become counter-clockwise, in space they run as most of their faces do, or the first. Ids stay, and the
 * first corner of a face stays its first. AMST_LOG_WARNING tells how many, and of what mostly is a mistake:
 * components of one face, vertices that hang in the middle of an edge, edges without length. A refusal names
 * the first of each kind of defect, and says how many there are.
 * Errors: ARGUMENT (dim, stride, corners_per_face; a boundary that cannot be kept), RANGE (corner
 * id, count, coordinate), NOT_FOUND (an edge of the options is no side of a face), NOT_FINITE, NOT_QUAD,
 * NOT_MANIFOLD;
 * ids in their sentences are those given. */
AMST_TRY amst_status amst_mesh_create(amst_context *ctx, int32_t dim, const double *coords,
                                      int64_t n_vertices, int64_t vertex_stride, int64_t component_stride,
                                      const int32_t *faces, int64_t n_faces, int64_t face_stride,
                                      int64_t corner_stride, int32_t corners_per_face,
                                      const amst_options *options, amst_mesh **out);
/* The same with 64-bit corner ids; they must still fit amst_id. */
AMST_TRY amst_status amst_mesh_create_i64(amst_context *ctx, int32_t dim, const double *coords,
                                          int64_t n_vertices, int64_t vertex_stride, int64_t component_stride,
                                          const int64_t *faces, int64_t n_faces, int64_t face_stride,
                                          int64_t corner_stride, int32_t corners_per_face,
                                          const amst_options *options, amst_mesh **out);
/* Format by extension; path is UTF-8:
 *
 *   extension        reads                            writes      markers and names     fields
 *   .off .obj .ply   ASCII, .ply also binary          ASCII       none                  none
 *   .msh (Gmsh)      1, 2.2, 4.0, 4.1 ASCII,          2.2 ASCII   all                   none
 *   .msh4            2.2, 4.1 binary                  4.1 ASCII   all above 0           none
 *   .su2             all                              all         of edges              none
 *   .inp (Abaqus)    meshes of one part               -           all                   none
 *   .vtk (legacy)    ASCII, binary                    ASCII       all                   not of edges
 *   .vtu (VTK XML)   ASCII, base64, raw, zlib         raw         all                   not of edges
 *   .amst            version 1                        version 1   all                   all
 *
 * dim is 2 when every z is 0. Triangles become quads as in amst_mesh_create; none is merged with one of
 * another region or over an edge with a marker, the halves of such an edge keep its marker, vertices with a
 * marker keep their faces, and fields of vertices are interpolated where new ones come.
 *  .msh  Markers of points, edges and faces are the numbers of physical groups, whose names are kept. Of
 *        several groups the smallest number counts, and AMST_LOG_WARNING tells. If no line is in a
 *        group, edges have the numbers of their curves. Meshes in parts are read whole.
 *  .su2  The boundaries get the markers 1, 2, ... in the order of the file, and their tags as names.
 *  .inp  Shells and elements in a plane of 3 or 4 nodes, and lines of 2. The k-th set or surface of a name
 *        is number k: sets of elements of faces and lines, surfaces of edges (with SPOS and SNEG of faces),
 *        sets of one node of this vertex, of several nodes of the edges of the boundary between them. Of
 *        several sets the first counts, and AMST_LOG_WARNING tells. Nodes to be generated are refused.
 *  .vtk, .vtu
 *        Markers of faces, lines and vertex cells are the first of these data of cells that is there, in
 *        whole numbers: "marker", "gmsh:physical", "medit:ref", "cell_tags", "MaterialIds", "RegionId",
 *        "CellEntityIds", the last not of vertex cells. All other data of points and cells become fields of
 *        vertices and faces: INHERIT those in whole numbers and "cross", else LINEAR and CONSERVE. Names of
 *        markers and carry rules are data of the whole set, such as "marker edge inlet" and "carry vertex
 *        heat". Data that are no field, such as those with values that are not finite, are left out.
 *  .amst A checkpoint, bit for bit: ids, flags, markers, names, fields, the surface and the boundary to keep
 *        to, and the revision, so that what follows is the same as with the mesh that was written; without
 *        savepoints and the projection of amst_mesh_set_projection. options have no effect. Every damaged
 *        byte is found.
 * A line with a marker that is no edge of a face is left out, and so is a point that no face has.
 * AMST_LOG_WARNING tells, and the result is AMST_PARTIAL, unless it was the number of a curve. A byte-order
 * mark of UTF-8 is passed over. Damaged files are refused with the line or byte, and take memory for what
 * their bytes hold (about ten times as much at most), not for what they promise.
 * Errors: IO, FORMAT, UNSUPPORTED (extension, binary variant, version) and those of amst_mesh_create. */
AMST_TRY amst_status amst_mesh_read(amst_context *ctx, const char *path, const amst_options *options,
                                    amst_mesh **out);
/* The same formats but .inp, and .svg, a picture with the singularities marked and, if there is an edge
 * field "chord", with a line through each face between opposite edges of equal value, whose colour the value
 * chooses. Faces are blue or red if there is a face field "size error" of 1 component, the more so the
 * farther it is below or above 0. A curved mesh is shaded, and what lies behind it is left out. In .su2
 * markers without a name are named by their numbers; in .msh4 faces come in the order of their markers, so
 * that their ids change; in .vtk and .vtu edges with a marker are line cells, vertices with one vertex cells.
 * AMST_LOG_WARNING tells what is left out. A failure leaves no half-written file. Errors: IO, UNSUPPORTED
 * (extension). */
AMST_TRY amst_status amst_mesh_write(const amst_mesh *mesh, const char *path);
/* A mesh of its own, with flags, markers, fields and revision, without savepoints. */
AMST_TRY amst_status amst_mesh_clone(const amst_mesh *mesh, amst_mesh **out);
/* The same in another context, or in the same one: for threads that work at the same time, each on a clone of
 * its own. Ids are from the index base of ctx. No function of amst_mesh_set_projection comes along, as it
 * might be called on several threads at once. */
AMST_TRY amst_status amst_mesh_clone_into(const amst_mesh *mesh, amst_context *ctx, amst_mesh **out);
AMST_API void amst_mesh_destroy(amst_mesh *mesh);

/* 2 or 3 coordinates a point */
AMST_TRY amst_status amst_mesh_get_dim(const amst_mesh *mesh, int32_t *dim);
/* Number of vertices, edges or faces. Errors: ARGUMENT (entity). */
AMST_TRY amst_status amst_mesh_get_count(const amst_mesh *mesh, int32_t entity, int64_t *count);
/* Rises with every change of connectivity; never repeats in one mesh, except
 * that rollback returns to the number it names. */
AMST_TRY amst_status amst_mesh_get_revision(const amst_mesh *mesh, int64_t *revision);
/* [n_vertices][dim] */
AMST_TRY amst_status amst_mesh_get_points(const amst_mesh *mesh, double *out, int64_t capacity,
                                          int64_t *needed);
/* New positions for all n vertices, [n][dim]; connectivity and revision stay.
 * Errors: RANGE (n is not the number of vertices, coordinate), NOT_FINITE. */
AMST_TRY amst_status amst_mesh_set_points(amst_mesh *mesh, const double *points, int64_t n);
/* [n_faces][4] vertices */
AMST_TRY amst_status amst_mesh_get_faces(const amst_mesh *mesh, amst_id *out, int64_t capacity,
                                         int64_t *needed);
/* [n_edges][2] vertices, smaller id first */
AMST_TRY amst_status amst_mesh_get_edges(const amst_mesh *mesh, amst_id *out, int64_t capacity,
                                         int64_t *needed);
/* [n_edges][2] faces: left then right of the edge; on the boundary the one face there is, then "none". */
AMST_TRY amst_status amst_mesh_get_edge_faces(const amst_mesh *mesh, amst_id *out, int64_t capacity,
                                              int64_t *needed);
/* Faces around each vertex, counter-clockwise, on the boundary from one of its edges to the other: those of
 * all vertices in a row in out, 4 a face in all. offsets has room for n_vertices + 1: where in out, counted
 * from the index base, the faces of each vertex begin; the last one is behind all. NULL for both asks. */
AMST_TRY amst_status amst_mesh_get_vertex_faces(const amst_mesh *mesh, int32_t *offsets, amst_id *out,
                                                int64_t capacity, int64_t *needed);
/* An amst_geometry of every face or edge: what a code needs that solves on the mesh. Areas are
 * AMST_METRIC_AREA. Errors: ARGUMENT (key). */
AMST_TRY amst_status amst_mesh_get_geometry(const amst_mesh *mesh, int32_t key, double *out, int64_t capacity,
                                            int64_t *needed);
/* Edge of each of n vertex pairs, "none" where there is no such edge; edges has
 * room for n ids. Errors: RANGE (vertex, n). */
AMST_TRY amst_status amst_mesh_find_edges(const amst_mesh *mesh, const amst_id *pairs, int64_t n,
                                          amst_id *edges);
/* What pairs of triangles did to edges when the mesh was created or read; the ids are those of that time,
 * whatever became of the mesh, and clones have the same. [n][2] vertices of sharp edges that are within quads
 * since then; ascending. */
AMST_TRY amst_status amst_mesh_get_crossed_edges(const amst_mesh *mesh, amst_id *out, int64_t capacity,
                                                 int64_t *needed);
/* [n][3]: two vertices, smaller id first, and the new one at the midpoint of the edge between them, which may
 * be half of another edge. */
AMST_TRY amst_status amst_mesh_get_split_edges(const amst_mesh *mesh, amst_id *out, int64_t capacity,
                                               int64_t *needed);
/* [n_vertices] number of edges at each vertex */
AMST_TRY amst_status amst_mesh_get_valences(const amst_mesh *mesh, int32_t *out, int64_t capacity,
                                            int64_t *needed);
/* Interior vertices of valence != 4, ascending. */
AMST_TRY amst_status amst_mesh_get_singularities(const amst_mesh *mesh, amst_id *out, int64_t capacity,
                                                 int64_t *needed);
/* Full check of connectivity and, for dim 2, orientation: no corner turned over or
 * flat. The first fault is in amst_last_error_where. */
AMST_TRY amst_status amst_mesh_check(const amst_mesh *mesh);
/* 64-bit digest of coordinates, connectivity, flags and markers; equal meshes,
 * equal digest. Fields and names of markers are not in it. */
AMST_TRY amst_status amst_mesh_get_checksum(const amst_mesh *mesh, int64_t *digest);

/* -------------------------------------------------------------------- flags */

/* For the n given entities set the amst_flag bits in mask as they are in value. ids
 * NULL stands for all entities, whatever n is. Vertices with a marker stay CORNER. The revision stays.
 * Errors: ARGUMENT (entity), RANGE (id, n, bits that are no flag). */
AMST_TRY amst_status amst_mesh_set_flags(amst_mesh *mesh, int32_t entity, const amst_id *ids, int64_t n,
                                         int32_t mask, int32_t value);
/* amst_flag bits of every vertex, edge or face. Errors: ARGUMENT (entity). */
AMST_TRY amst_status amst_mesh_get_flags(const amst_mesh *mesh, int32_t entity, int32_t *out,
                                         int64_t capacity, int64_t *needed);
/* Flags the edges whose two faces have normals more than angle degrees apart, 0..180, as
 * FEATURE; and as CORNER the vertices where curves of FEATURE edges, these and those that
 * had the flag before, end or cross (one or more than two edges of them) or turn by more
 * than 60 degrees, but not right back: that is a fold. No flag is taken away; the revision stays. found, the
 * number of edges at more than angle, may be NULL. Errors: NOT_FINITE, RANGE (angle). */
AMST_TRY amst_status amst_mesh_detect_features(amst_mesh *mesh, double angle, int64_t *found);

/* ------------------------------------------------------------------ markers */
/* Numbers that say what belongs together: edges of a boundary or of a line inside, faces of a region, points.
 * 0 is no marker, any other number is one; they are no ids, so the index base has no say in them. They are
 * part of the mesh as its flags are, in the checksum, too, and come from files or from amst_mesh_set_markers.
 * Edges with a marker and borders of regions act as FEATURE: every operation keeps these curves, and pieces
 * of an edge or a face have the marker of the whole. Vertices with a marker are CORNER, which
 * amst_mesh_set_flags does not change: they do not move and do not go.
 * Each marker of each kind of entity may have a name, whether it is in use or not; names are part of the
 * mesh, but not of the checksum. Which formats hold markers and names is said at amst_mesh_read. */

/* The marker of the n given entities becomes value, 0: none. ids NULL stands for all entities, whatever n is.
 * Vertices become CORNER if value is not 0, and stay it if it is. The revision stays.
 * Errors: ARGUMENT (entity), RANGE (id, n). */
AMST_TRY amst_status amst_mesh_set_markers(amst_mesh *mesh, int32_t entity, const amst_id *ids, int64_t n,
                                           int32_t value);
/* [count] marker of every vertex, edge or face, 0: none. Errors: ARGUMENT (entity). */
AMST_TRY amst_status amst_mesh_get_markers(const amst_mesh *mesh, int32_t entity, int32_t *out,
                                           int64_t capacity, int64_t *needed);
/* The markers that some vertex, edge or face has, each once, ascending. Errors: ARGUMENT (entity). */
AMST_TRY amst_status amst_mesh_get_marker_list(const amst_mesh *mesh, int32_t entity, int32_t *out,
                                               int64_t capacity, int64_t *needed);
/* name: UTF-8 without control characters and double quotes, ended by 0, copied; NULL or "" takes the name
 * away. The revision stays. Errors: ARGUMENT (entity, marker 0, name). */
AMST_TRY amst_status amst_mesh_set_marker_name(amst_mesh *mesh, int32_t entity, int32_t marker,
                                               const char *name);
/* The name with the 0 that ends it, which `needed` counts, too; "" if the marker has none.
 * Errors: ARGUMENT (entity). */
AMST_TRY amst_status amst_mesh_get_marker_name(const amst_mesh *mesh, int32_t entity, int32_t marker,
                                               char *out, int64_t capacity, int64_t *needed);

/* ------------------------------------------------------------------- fields */
/* Named reals on every vertex, edge or face, [count][components], at most one field of
 * a name on each kind of entity. They are part of the mesh as its flags are, but not of
 * files. An operation keeps the values of the entities that it keeps, bit for bit, and
 * gives new ones values by the carry rule out of the faces that it replaced or whose
 * shape it changed:
 *  DROP      the field is removed by an operation that changes connectivity.
 *  INHERIT   the value of the nearest entity at those faces, measured between points,
 *            midpoints of edges and centroids of faces; the smallest id of several. Edges on the
 *            boundary take from such edges only, edges inside from edges inside, of the same marker if there
 *            is one; 0 where there was none.
 *  LINEAR    for vertices, and those that have moved are as good as new: interpolated at the nearest point
 *            of those faces, each as two triangles. In a plane linear functions are reproduced; beyond the
 *            boundary as it was the nearest face is continued, so that values may leave the range of those
 *            that they are taken from, but not those of "size".
 *  CONSERVE  for faces and vertices: values are means over the face, or over what the vertex
 *            has: the quarter of each of its faces between the middles of two edges and the mean of
 *            its corners. The new mean is that of the field before, which is linear on each face
 *            (or what a vertex has): with its mean, and the gradient that fits those around it
 *            best, made less steep until nothing leaves their range. On faces it is not fitted
 *            over FEATURE edges, markers and borders of regions. In a plane linear functions are
 *            reproduced but near the boundary. The sum of value * area (AMST_METRIC_AREA) stays the
 *            same over each connected set of those faces; so a face that was kept but changed its
 *            shape gets a new value, too. Where the set itself
 *            gains or loses area in a plane, as AMST_OPT_EDIT_BOUNDARY may do, its mean stays
 *            instead, so that constants do; AMST_RESULT_AREA_GAINED tells how much.
 *  AVERAGE   as CONSERVE, but the field before is constant on each face: of first order, it smears more.
 * No rule leaves the range of the values it takes from, but for LINEAR as above, and for CONSERVE and AVERAGE
 * on curved faces and where the area changes. amst_mesh_set_points leaves all
 * fields as they are. Names are UTF-8. The library reads "size" (vertices, 1 component):
 * the wanted edge length, 1e-30 to 1e30; and "cross" (faces, 3 components, also for dim 2): a
 * direction that edges shall have there, or one at right angles to it; 0 0 0 for none.
 * amst_adapt and amst_reduce_singularities write to "size error" (faces, 1 component), if there is such a
 * field, log2(area / wanted area) of each face of the patches or of the whole mesh, as
 * AMST_RESULT_SIZE_ERROR_AFTER has it; where they want no size, or know none, the carry rule holds. */

/* A new field, or a new one in the place of the old; n is the number of vertices, edges
 * or faces. The revision stays. Errors: ARGUMENT (entity, name empty, carry, carry not
 * for this entity, "size" or "cross" on another entity), RANGE (components < 1 or not those
 * of "size" or "cross", n, "size" not from 1e-30 to 1e30), NOT_FINITE. */
AMST_TRY amst_status amst_mesh_set_field(amst_mesh *mesh, int32_t entity, const char *name,
                                         int32_t components, int32_t carry, const double *values, int64_t n);
/* [count][components]. Errors: ARGUMENT (entity, name empty), NOT_FOUND. */
AMST_TRY amst_status amst_mesh_get_field(const amst_mesh *mesh, int32_t entity, const char *name, double *out,
                                         int64_t capacity, int64_t *needed);
/* Errors: ARGUMENT (entity, name empty), NOT_FOUND. */
AMST_TRY amst_status amst_mesh_remove_field(amst_mesh *mesh, int32_t entity, const char *name);

/* From error to mesh: writes the vertex field "size", of AMST_CARRY_LINEAR, that amst_adapt goes by.
 * indicator [n_faces] is what a face contributes to the error, at least 0, like h^ERROR_ORDER for edges of
 * length h; where fronts are sharp the jump across the face will do, with order 1. A face asks for the length
 * at which its indicator is `tolerance`, the root of its area now times (tolerance / indicator)^(1 / order),
 * between MIN_EDGE and MAX_EDGE. A vertex asks for the least of its faces and of BUFFER_LAYERS further layers
 * of faces, so that a front stays in small faces until the next call. No size grows by more than GRADATION
 * times the way along edges and diagonals. faces: limit of the number of faces of the whole mesh, 0: none.
 * Where the sizes ask for more, the tolerance is raised until they do not, or MIN_EDGE does not allow it.
 * tolerance 0: as many as `faces`, with equal error everywhere. No other options count. With
 * AMST_OPT_SIZE_BAND amst_adapt does not touch a place whose size hardly changes. asked_faces, the number of
 * faces that the sizes ask for, the sum of area / size^2, may be NULL; it is further from `faces` than 1 in
 * 1,000 only where MIN_EDGE, MAX_EDGE or GRADATION do not allow it. Takes time in proportion to the faces, on
 * one thread. The revision stays. Errors: RANGE (n, an indicator, tolerance or faces below 0, both 0),
 * ARGUMENT (MAX_EDGE below MIN_EDGE), NOT_FINITE, STATE. */
AMST_TRY amst_status amst_mesh_size_from_indicator(amst_mesh *mesh, const double *indicator, int64_t n,
                                                   double tolerance, int64_t faces,
                                                   const amst_options *options, double *asked_faces);

/* What the faces of two meshes of one domain share, for codes that carry their fields themselves, as between
 * amst_mesh_clone of a mesh and that mesh after an operation: rows of a face of `before`, a face of `after`
 * and the area of both, above 0; ascending by the face of `after`, then of `before`, each id from the index
 * base of its mesh. In a plane the rows of a face sum up to its area where the other mesh covers it.
 * Elsewhere faces are seen along the normal of the face of `after`, and faces that look the other way share
 * nothing. All three arrays hold `capacity`; NULL for all tells the number of rows only, and costs as much: n
 * log n for n faces. Errors: ARGUMENT (one mesh has dim 2, the other 3). */
AMST_TRY amst_status amst_mesh_get_overlap(const amst_mesh *before, const amst_mesh *after,
                                           amst_id *before_faces, amst_id *after_faces, double *areas,
                                           int64_t capacity, int64_t *needed);

/* A new face field "cross", of AMST_CARRY_INHERIT, in the place of any old one: directions
 * of length 1 in the planes of the faces. They are along the edges on the boundary, on
 * FEATURE and on borders of markers; elsewhere along the principal directions, the more the
 * curvatures in them differ; and between that as smooth as can be. Of the options
 * SMOOTH_STEPS counts, the sweeps on each level of the hierarchy of faces. Takes time in
 * proportion to the faces, on one thread. The revision stays. Errors: STATE, CANCELLED. */
AMST_TRY amst_status amst_mesh_compute_cross_field(amst_mesh *mesh, const amst_options *options);
/* Mean angle between the sides of faces and the nearest of the four directions of "cross"
 * and at right angles to it, 0..45 degrees: 0 where edges follow the field, 22.5 where they
 * do not know of it. Sides and directions without length do not count; 0 if none does.
 * Errors: NOT_FOUND (no field "cross"). */
AMST_TRY amst_status amst_mesh_get_alignment(const amst_mesh *mesh, double *mean_degrees);

/* ------------------------------------------------------------------ surface */

/* The surface that a curved mesh keeps to: operations project the vertices to it that they
 * move or add. points [n_points][dim], triangles [n_triangles][3] with ids of those points
 * from the index base; at least one triangle has an area, and others without do no harm. NULL points
 * takes the mesh as it is now, two triangles a face, whatever the other arguments are.
 * Until this is called it is the mesh as it is when the first operation on it begins. The
 * surface is part of the mesh as its fields are, but not of the checksum; the revision
 * stays. Errors: RANGE (counts, a triangle with a corner that is no point, coordinate, no area),
 * NOT_FINITE. */
AMST_TRY amst_status amst_mesh_set_surface(amst_mesh *mesh, const double *points, int64_t n_points,
                                           const int32_t *triangles, int64_t n_triangles);

/* ----------------------------------------------------------------- boundary */

/* The boundary as the caller knows it, for AMST_OPT_EDIT_BOUNDARY; NULL fn: as the edges of the mesh have
 * it. An operation with that option calls fn once when it begins, for points on edges of the boundary, to
 * learn where it runs, and once in the end, for new vertices, which come to lie where it says, bit for bit.
 * It is called on the thread that made the call, may not use the mesh but to ask, and gives equal
 * results for equal points. The call fails with AMST_ERR_PROJECTION, and nothing has changed, if it returns
 * non-zero, if a result is not finite or farther off than AMST_OPT_TOLERANCE edges, and if a
 * new vertex turned a face over there. fn and user must live as long as the mesh and its copies,
 * or until they are replaced. Not kept in files. Errors: STATE. */
AMST_TRY amst_status amst_mesh_set_projection(amst_mesh *mesh, amst_projection_fn fn, void *user);

/* ------------------------------------------------------------------ undoing */

/* Remember the mesh: points, connectivity, flags, markers, fields. Savepoints nest. revision
 * names the savepoint; of several with one name the latest is meant. Memory is taken
 * only when the mesh changes. */
AMST_TRY amst_status amst_mesh_mark(amst_mesh *mesh, int64_t *revision);
/* Back to a savepoint, which stays; later ones are forgotten. Patch sets of its
 * revision are current again. Errors: NOT_FOUND. */
AMST_TRY amst_status amst_mesh_rollback(amst_mesh *mesh, int64_t revision);
/* Give up one savepoint; the mesh stays as it is. Errors: NOT_FOUND. */
AMST_TRY amst_status amst_mesh_forget(amst_mesh *mesh, int64_t revision);

/* ------------------------------------------------------------------ patches */
/* A patch set belongs to one revision of one mesh; operations given the set move
 * it along to the new revision and the new faces. Other changes make it STALE.
 * Faces that an earlier patch has, or that are FIXED, are left out of a new one;
 * AMST_OPT_REPAIR_PATCHES then makes it a disk if it can, but leaves a ring: what
 * encloses a hole of two faces or more that has over a tenth of its own. `patch` of an add call
 * receives the new patch's id and may be NULL.
 * Errors of all but create, destroy and get_count: STALE; RANGE (patch, face, vertex,
 * count). Errors of add calls: PATCH (no face would be left), NOT_FINITE. */

/* The options that count are REPAIR_PATCHES, PATCH_FACES, MIN_CONVEXITY and SEED; they
 * are copied. */
AMST_TRY amst_status amst_patches_create(const amst_mesh *mesh, const amst_options *options,
                                         amst_patches **out);
AMST_API void amst_patches_destroy(amst_patches *patches);
/* n faces in any order; repetitions do not count. With AMST_OPT_REPAIR_PATCHES 0 a
 * face that is taken or FIXED is AMST_ERR_PATCH. */
AMST_TRY amst_status amst_patches_add_faces(amst_patches *patches, const amst_id *faces, int64_t n,
                                            amst_id *patch);
/* The faces within `rings` face layers of a vertex; 1: the faces at it. */
AMST_TRY amst_status amst_patches_add_rings(amst_patches *patches, amst_id vertex, int32_t rings,
                                            amst_id *patch);
/* The connected faces around the one nearest to center, centroid within radius >= 0.
 * A mesh of dim 2 lies in the plane z = 0. Errors: ARGUMENT (radius < 0). */
AMST_TRY amst_status amst_patches_add_ball(amst_patches *patches, const double center[3], double radius,
                                           amst_id *patch);
/* The faces with their centroid in the box, the largest connected part of them.
 * Errors: ARGUMENT (low above high). */
AMST_TRY amst_status amst_patches_add_box(amst_patches *patches, const double low[3], const double high[3],
                                          amst_id *patch);
/* Automatic patches of about AMST_OPT_PATCH_FACES faces over the faces not yet taken,
 * by a method of amst_decomposition. added, the number of new patches, may be NULL; it
 * can be 0. CLUSTERS, PARTITION and VORONOI cover the faces but for some that no disk
 * could hold. Without randomness: MEDIAL, but see below, and SINGULARITIES.
 *
 * MEDIAL: circles bounded by the mesh boundary, flags, markers, taken faces and the discs
 * before, the largest first. A disc has AMST_OPT_PATCH_FACES faces, the innermost, where
 * more fit, and at least a quarter of that; what is left between discs gets no patch.
 * Where nothing bounds the faces, as on a closed surface, the first disc is around a face
 * that AMST_OPT_SEED chooses and each later one as far as can be from those before.
 * SINGULARITIES: singular vertices share a patch where one can hold them; each away from
 * boundary, flags, markers and taken faces is in a patch, faces far from all are in none.
 * Errors: ARGUMENT (method), CANCELLED. */
AMST_TRY amst_status amst_patches_decompose(amst_patches *patches, int32_t method, int64_t *added);
/* 3 to 6 boundary vertices in boundary order, counter-clockwise; n = 0 lets the
 * library choose. Whether they are that is told by amst_patches_check. Errors: RANGE
 * (vertex, n). */
AMST_TRY amst_status amst_patches_set_corners(amst_patches *patches, amst_id patch, const amst_id *vertices,
                                              int64_t n);
/* alpha of one patch, or of all that are in the set now (AMST_ALL); 0 means: that of
 * the operation. Errors: ARGUMENT (alpha < 0), NOT_FINITE. */
AMST_TRY amst_status amst_patches_set_alpha(amst_patches *patches, amst_id patch, double alpha);

AMST_TRY amst_status amst_patches_get_count(const amst_patches *patches, int64_t *count);
/* ascending */
AMST_TRY amst_status amst_patches_get_faces(const amst_patches *patches, amst_id patch, amst_id *out,
                                            int64_t capacity, int64_t *needed);
/* Boundary vertices, counter-clockwise, from the first corner. Errors: PATCH (not a
 * disk). */
AMST_TRY amst_status amst_patches_get_boundary(const amst_patches *patches, amst_id patch, amst_id *out,
                                               int64_t capacity, int64_t *needed);
/* The corners that were set; otherwise the boundary vertices where one face fits.
 * Errors: PATCH (not a disk). */
AMST_TRY amst_status amst_patches_get_corners(const amst_patches *patches, amst_id patch, amst_id *out,
                                              int64_t capacity, int64_t *needed);
/* defects: amst_defect bits, 0 if usable. convexity: area over that of the convex hull,
 * 0..1, 1 convex, 0 if the patch is no disk; may be NULL. */
AMST_TRY amst_status amst_patches_check(const amst_patches *patches, amst_id patch, int32_t *defects,
                                        double *convexity);

/* Picture (.svg) of the mesh with the patch outlines and the singularities, faces in the colours of
 * amst_mesh_write; a failure leaves no half-written file. Errors: IO, UNSUPPORTED (extension). */
AMST_TRY amst_status amst_patches_write(const amst_patches *patches, const char *path);
/* What amst_adapt would deliver for that patch and alpha, without doing it: the
 * exact number of faces and of singularities. A very small alpha gives the fewest faces that
 * the boundary allows. Takes as long as doing it, since the best filling is told by its
 * sizes and shapes. Either output may be NULL.
 * Errors: ARGUMENT (alpha <= 0), NOT_FINITE, RANGE (too many faces), PATCH, NO_FILLING, GEOMETRY. */
AMST_TRY amst_status amst_patches_predict(const amst_patches *patches, amst_id patch, double alpha,
                                          const amst_options *options, int64_t *faces,
                                          int64_t *singularities);

/* --------------------------------------------------------------- operations */
/* Each changes the mesh or, on failure and on cancel, not at all; it works on a copy,
 * so that for a moment the mesh takes twice its memory. `report` may be NULL; the
 * report written there is the caller's. Patches with defects are left and make the
 * result AMST_PARTIAL, but amst_adapt takes rings and regions with several holes (no
 * defect but NOT_DISK). The patch set moves along. After AMST_PARTIAL amst_last_error says
 * what was in the way, of the first patch that it is about; the log says it of all.
 * Errors: ARGUMENT (patches of another mesh), STALE, STATE, CANCELLED. */

/* Replace each patch by its alpha template: round(alpha * faces) faces, few singular vertices, the border
 * as it is. alpha > 0 is for the patches that have none of their own.
 *
 * Sizes: at the border, whose edges stay, faces are wanted as large as they were; inside they are wanted
 * smaller or larger by one factor, so that the count is reached, with a smooth transition in between
 * (TRANSITION). Of fillings with few singular vertices the one is taken that has these sizes best and good
 * angles; none with a face below an eighth of what is wanted (LEAST_SIZE), unless there was one.
 *
 * Where the boundary of a patch in a plane does not allow that number of faces, the nearest that it allows is
 * made and the status of the patch is AMST_PARTIAL: a boundary of n edges needs n / 2 - 1 faces, and more
 * where its angles do. A ring, a region with several holes, or a curved patch that no single filling covers
 * is refilled in parts, which costs some singular vertices.
 *
 * At alpha 1 a patch keeps its sizes; its singular vertices do not become more and its smallest scaled
 * Jacobian does not fall. Where nothing is gained it stays bit for bit, and so does a whole mesh without
 * ALIGN and without a field "size".
 *
 * patches NULL: the whole mesh, by windows: disks that the library chooses, grows and moves over it; a mesh
 * of at most 1,000 faces first piece by piece, as if each connected piece between features, markers and fixed
 * faces were a patch. It gets round(alpha * faces) faces, or the result is AMST_PARTIAL, and as few singular
 * vertices as can be; its boundary stays. Boundary layers in a plane (rows of faces eight times longer than
 * high) stay, too, unless the count cannot be had so, the mesh becomes much coarser, or a field "size"
 * speaks. Same mesh, options and seed, same result, on any number of threads.
 *
 * Curved meshes keep to their surface, see amst_mesh_set_surface: it and what is filled anew stay within
 * AMST_OPT_TOLERANCE of each other. What cannot be filled so, patches and the last faces of a whole mesh, may
 * be up to 3 times as far; a patch that cannot be filled so either is left with AMST_ERR_GEOMETRY.
 *
 * What counts in amst_adapt (A), amst_reduce_singularities (R), amst_smooth (S) and amst_clean (C):
 *
 *                   patches      patches on a    whole mesh    whole mesh
 *                   on a plane   curved mesh     in a plane    curved
 *   SEED            A R          A R             A R C         A R C
 *   SMOOTH_STEPS    A R S        A R S           A R S C       A R S C       A R of a whole mesh: at most 10
 *   CANDIDATES      A R          A R             A R C         A R C         a window: 3/16 of it, at least 1
 *   NODE_LIMIT      A R          A R             A R C         A R C
 *   MIN_QUALITY     A R          A R             A R C         A R C
 *   EFFORT          A R          A R             A R C         A R C
 *   SIZE_WEIGHT     A R S        A R             A R S C       A R C         S of plane patches of any mesh
 *   TRANSITION      A R          A R             A R C         A R C
 *   LEAST_SIZE      A R          A R             A R C         A R C
 *   TOLERANCE       A R          A R S           A R           A R S         plane, S: if EDIT_BOUNDARY is 1
 *   CHART           -            A R             -             A R C
 *   ALIGN           -            A R             -             A R
 *   field "cross"   -            A R             -             A R           with ALIGN only
 *   field "size"    A R          A R             A R           A R
 *   SIZE_BAND       -            -               A             -             with field "size" only
 *   STARTS          -            -               A R           A R           not with SIZE_BAND, STRATEGY 1
 *   STRATEGY        -            -               A             A
 *   EDIT_BOUNDARY   A R          S               A R           A R S
 *
 * Patches on a plane: all are plane, and the mesh has no surface yet. A plane patch on a curved mesh needs no
 * CHART. Whole meshes are filled as patches are where they are small (up to 1,000 faces), where faces would
 * get too small, and where their number cannot be had otherwise; elsewhere in them TRANSITION says nothing,
 * on a surface SIZE_WEIGHT and LEAST_SIZE neither. What amst_clean mends is filled as patches are.
 *  EFFORT    The search for a better filling of a patch, or for one at all, and that for fewer singular
 *            vertices in a whole mesh go on for so many times as long, as far as CANDIDATES allows. A lake
 *            of 10,790 faces takes 2.1 s with .1 (67 singular vertices) and 3.3 s with 1 (34); a scan that
 *            becomes one of 3,305 takes 2.9 s (58), 6.4 s (28) and, with 4, 20 s (24).
 *  SIZE_WEIGHT  With more, faces come nearer to the wanted sizes; with less, to squares.
 *  TRANSITION  Over that part of the greatest distance from the border of a patch sizes change. A half leaves
 *            a core of a quarter of the area and faces that grow by less than 1.3 from one to the next at
 *            alpha 4. With less the core is larger and its faces need not be so small; but they grow faster.
 *  LEAST_SIZE  A filling with a smaller face is not taken, unless there was one as small before; smoothing of
 *            a whole mesh may leave smaller ones. With more a patch may be left or miss its count, and near 1
 *            hardly any filling does, after a long search; with 0 faces may have any size.
 *  CHART     The map that lays what is curved in the plane to be filled: 0 projects what turns little, else
 *            puts each vertex on a disk amid its neighbours (Tutte); 1 the same by mean value coordinates;
 *            2 keeps angles and lets the border go where it wants; 3 stretches less on the disk. A map that
 *            folds is not used: 2 and 3 give way to 1, and that to Tutte's, which never does.
 *  ALIGN     Of fillings with the same numbers the one along "cross" is taken or, without that field, along
 *            what amst_mesh_compute_cross_field would give. Edges of a whole mesh turn to it at last.
 *  "size"    The wanted edge length says where the faces go. Without it those of a patch and of a whole mesh
 *            in a plane go where they were, and those of a curved whole mesh where it bends more.
 *  SIZE_BAND For codes that adapt while they solve: above 0, amst_adapt of a whole plane mesh takes "size"
 *            at its word, alpha times as dense, and changes only places where log2 of area / wanted area
 *            is beyond that, and a few layers of faces around them; all others stay bit for bit, and so do
 *            their fields. .7 suits a front that moves by less than its width. The number of faces wanted
 *            is what "size" asks for where faces change, and those that stay. For which length a place was
 *            last adapted, or found good, is kept in the vertex field "adapted size", which appears: it is
 *            taken again only if what is wanted there has changed by half of SIZE_BAND, so that an equal
 *            call changes nothing. Remove the field to have all looked at anew. Size errors in the report
 *            are those of the places that change. With EDIT_BOUNDARY 1 vertices of the boundary
 *            come and go there, too. No effect with STRATEGY 1.
 *  STARTS    So many searches with different luck share the threads of the context, and the best is kept: by
 *            the number of faces, then by singular vertices, sizes and shapes together. The first has the
 *            SEED itself, so more starts are never worse. Each thread holds a copy of the mesh. The log tells
 *            what each came to.
 *  STRATEGY  1: whole chords are removed, the shortest first, or split until no other one can go without
 *            passing the number of faces. No vertex becomes singular. Of the other options only SMOOTH_STEPS
 *            and EDIT_BOUNDARY count, and SIZE_WEIGHT in a plane.
 *  EDIT_BOUNDARY  0: the boundary of a plane mesh stays as it is, vertex for vertex. 1: vertices come
 *            and go on it, where edges would be far from the length that is wanted, and where that saves
 *            singular vertices: the length of the field "size"; or as long as they were, times the change
 *            of the faces there (half as long at alpha 4), but no shorter than the faces are wide. New ones
 *            lie on the boundary as it was when an operation first had this option, or see
 *            amst_mesh_set_projection, and new edges miss it by TOLERANCE wanted edges at most. These stay:
 *            vertices with a flag, those where markers change (not the tags of curves in a file of Gmsh
 *            without physical groups), where something ends, and corners, where the boundary turns by
 *            more than 60 degrees and does not turn back within two edges. New edges have the marker,
 *            the flags and the origin of the one at their middle. Where a whole mesh is made of rows and
 *            columns, with stretched rows along the boundary, columns alone come and go: rows keep their
 *            heights.
 *            On a curved mesh, and with STRATEGY 1, 1 lets chords take vertices from features and boundary
 *            where these turn by less than 30 degrees, as machine parts may need; vertices slide along
 *            features around such bends, which stay within a fifth of TOLERANCE of their edges; and new
 *            ones lie on the curve as it was when an operation first found it. With 0
 *            features lose and get vertices only where they are straight. With STRATEGY 0 there are chords
 *            only where a curved mesh that is nearly regular and has no field "size" begins with them.
 * Where a curved mesh cannot have the faces wanted, no more singular vertices are made than there were.
 * Errors: ARGUMENT (alpha <= 0), NOT_FINITE, RANGE (a patch of more than 100,000 faces, a mesh of more than
 * ids can name). */
AMST_TRY amst_status amst_adapt(amst_mesh *mesh, amst_patches *patches, double alpha,
                                const amst_options *options, amst_report **report);
/* Replace each patch by its minimum singularity template, boundary kept. patches
 * NULL: the whole mesh, as amst_adapt does with alpha 1, but for the exact number of
 * faces, which stays within a few percent. */
AMST_TRY amst_status amst_reduce_singularities(amst_mesh *mesh, amst_patches *patches,
                                               const amst_options *options, amst_report **report);
/* Move interior vertices of the patches, or of the mesh if patches is NULL; flagged
 * ones stay, and so does the revision. On a curved mesh a vertex with two edges that are
 * FEATURE, marked or borders of regions, both alike, slides between its neighbours on
 * them where the curve is straight, as it was when an operation first found it so flagged;
 * so no curve changes, unless AMST_OPT_EDIT_BOUNDARY lets them slide around bends, too. FIXED and CORNER
 * vertices stay. The same holds for whole meshes in amst_adapt and amst_reduce_singularities. In a plane
 * faces keep the sizes that there are around, or come to those of the field "size", for which scaled
 * Jacobians may fall, but none below a half; on a surface without that field sizes become even. */
AMST_TRY amst_status amst_smooth(amst_mesh *mesh, const amst_patches *patches, const amst_options *options,
                                 amst_report **report);
/* Remove doublets and split valences above 5. The revision rises if there were any. */
AMST_TRY amst_status amst_clean(amst_mesh *mesh, const amst_options *options, amst_report **report);

/* ------------------------------------------------------------------- chords */
/* A chord is the row of faces met when each is left through the edge opposite to the one
 * it was entered by: closed (cyclic), or open from boundary to boundary. Each edge is on
 * one chord; the lengths of all sum up to twice the faces. Chords are numbered from the
 * index base in the order of their smallest edges. */

/* Edges crossed by the chord through edge, in order: from that edge round if it is closed,
 * else from its end with the smaller edge. closed is 1 or 0; crossings counts the faces it
 * passes twice. Either may be NULL. Errors: RANGE (edge). */
AMST_TRY amst_status amst_mesh_get_chord(const amst_mesh *mesh, amst_id edge, int32_t *closed,
                                         int64_t *crossings, amst_id *out, int64_t capacity, int64_t *needed);
/* [n_edges] number of the chord of each edge; n_chords may be NULL. As an edge field
 * "chord" they are drawn in colour by amst_mesh_write. */
AMST_TRY amst_status amst_mesh_get_chord_ids(const amst_mesh *mesh, int64_t *n_chords, amst_id *out,
                                             int64_t capacity, int64_t *needed);
/* [n_chords] an amst_chord_property of each chord. Of the options AMST_OPT_EDIT_BOUNDARY
 * counts. Errors: ARGUMENT (property). */
AMST_TRY amst_status amst_mesh_get_chords(const amst_mesh *mesh, int32_t property,
                                          const amst_options *options, int64_t *out, int64_t capacity,
                                          int64_t *needed);

/* The next three are operations as those above; singular vertices are known beforehand.
 * The faces around the chord, two layers of them, are smoothed, on a curved mesh back to
 * its surface (AMST_OPT_SIZE_WEIGHT counts where they are plane, but not for
 * amst_insert_chords); where an element would turn over nothing is done. */

/* Remove the chord through edge: the two ends of each of its edges become one vertex. It
 * stays where it was if one of them may not move (boundary, flags, markers), else it goes
 * to the middle. An edge on the boundary or on a feature is only collapsed if
 * AMST_OPT_EDIT_BOUNDARY allows that, and the curve turns by less than 30 degrees where it
 * loses the vertex. Errors: RANGE (edge), CHORD (amst_last_error has the reason and its
 * place; all reasons: AMST_CHORD_REFUSAL), GEOMETRY. */
AMST_TRY amst_status amst_collapse_chord(amst_mesh *mesh, amst_id edge, const amst_options *options,
                                         amst_report **report);
/* Cut the chord through edge into n + 1 parallel ones, n >= 1; a face where it crosses
 * itself into (n + 1)^2. No vertex becomes singular. The vertices that are there stay; pieces of
 * edges and faces have their flags and markers, and their values in fields of AMST_CARRY_INHERIT. An open
 * chord puts vertices on the boundary and is only split if AMST_OPT_EDIT_BOUNDARY allows that.
 * Errors: RANGE (edge, n, size of the mesh), CHORD, GEOMETRY. */
AMST_TRY amst_status amst_split_chord(amst_mesh *mesh, amst_id edge, int32_t n, const amst_options *options,
                                      amst_report **report);
/* Lay n closed chords, 1 to 1000, around the core of each patch: rings between its boundary,
 * which stays, and its faces, which keep their connectivity. A patch needs 3 to 6 corners
 * (boundary vertices with one of its faces), or none, and two of its faces at all other
 * boundary vertices. The corners of the core become singular vertices of valence 3; where
 * the patch had no corner none is added: so their number does not depend on n. Corners
 * that were set must be these. Patches that are not so, or with defects, are left and make
 * the result AMST_PARTIAL. Errors: NULL (patches), RANGE (n). */
AMST_TRY amst_status amst_insert_chords(amst_mesh *mesh, amst_patches *patches, int32_t n,
                                        const amst_options *options, amst_report **report);

/* ------------------------------------------------------------------ quality */

/* [n_faces] an amst_metric of each face: areas and Jacobians in squared units of the
 * coordinates, angles in degrees, the others without a unit. Errors: ARGUMENT (metric). */
AMST_TRY amst_status amst_mesh_get_quality(const amst_mesh *mesh, int32_t metric, double *out,
                                           int64_t capacity, int64_t *needed);
/* Errors: ARGUMENT (metric). */
AMST_TRY amst_status amst_mesh_get_summary(const amst_mesh *mesh, int32_t metric, amst_summary *out);

/* ------------------------------------------------------------------- report */
/* Immutable; outlives mesh and patches. patch is an id or AMST_ALL; an operation that
 * had no patches has AMST_ALL only. A quality is the smallest AMST_METRIC_SCALED_JACOBIAN
 * of the faces of a patch or the mesh. Of AMST_ALL counts are sums and qualities the
 * smallest. Errors: RANGE (patch), NOT_FOUND (key of the other type or unknown). */

AMST_API void amst_report_destroy(amst_report *report);
AMST_TRY amst_status amst_report_get_int(const amst_report *report, amst_id patch, int32_t key,
                                         int64_t *value);
AMST_TRY amst_status amst_report_get_real(const amst_report *report, amst_id patch, int32_t key,
                                          double *value);
/* Interior vertices of one valence before (after = 0) or after the operation; those
 * of AMST_ALL are the ones of the whole mesh. */
AMST_TRY amst_status amst_report_get_valence(const amst_report *report, amst_id patch, int32_t after,
                                             int32_t valence, int64_t *count);
/* For each vertex, edge or face of the mesh after the operation the one it was before, "none" if
 * there is none. Vertices are the same if they were kept, though they may have moved; edges and faces if
 * their vertices are the same. So nothing is named twice: pieces of an edge or a face that was cut are new;
 * amst_mesh_get_overlap tells what they are part of. Errors: ARGUMENT (entity). */
AMST_TRY amst_status amst_report_get_origin(const amst_report *report, int32_t entity, amst_id *out,
                                            int64_t capacity, int64_t *needed);

#ifdef __cplusplus
}
#endif

#endif
