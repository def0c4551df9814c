// What is known of the shapes of some quads.
#pragma once

namespace alphamst::geometry {

struct Judgement {
    double min_determinant = 0; // smallest corner determinant (signed area of the corner)
    double min_scaled_jacobian = 0;
    double min_shape = 0; // Verdict's: 1 for a square, falls as quads get thin, too
    int inverted = 0;     // quads with a corner that is not positive
    int poor = 0;         // quads with an angle outside 45 to 135 degrees or a shape below 0.3
    bool valid = false;   // every corner determinant is positive
};

// Verdict's ranges for the smallest angle and the shape.
inline bool acceptable(double sine, double shape) { return sine >= 0.70710678 && shape >= 0.3; }

} // namespace alphamst::geometry
