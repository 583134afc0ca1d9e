// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

/// Polynomials on [0, 1] by their Bernstein coefficients: those of degree n at t are the mean of
/// the n + 1 numbers with the weights of the n-th Bernstein basis, and lie between the least and
/// the greatest of them.
namespace povpreview {

template <std::size_t Degree>
using Bernstein = std::array<double, Degree + 1>;

/// Value and slope at t, by de Casteljau's corner cutting.
struct ValueAndSlope {
    double value, slope;
};
template <std::size_t Degree>
ValueAndSlope bernstein_value(Bernstein<Degree> f, double t) {
    for (std::size_t left = Degree; left > 1; --left)
        for (std::size_t k = 0; k < left; ++k) f[k] += t * (f[k + 1] - f[k]);
    return {f[0] + t * (f[1] - f[0]), double(Degree) * (f[1] - f[0])};
}

/// The product of two polynomials, of the sum of their degrees.
template <std::size_t A, std::size_t B>
Bernstein<A + B> bernstein_product(const Bernstein<A>& a, const Bernstein<B>& b) {
    const auto choose = [](std::size_t n, std::size_t k) {
        double result = 1;
        for (std::size_t i = 0; i < k; ++i)
            result *= static_cast<double>(n - i) / static_cast<double>(i + 1);
        return result;
    };
    Bernstein<A + B> product{};
    for (std::size_t i = 0; i <= A; ++i)
        for (std::size_t j = 0; j <= B; ++j)
            product[i + j] += choose(A, i) * choose(B, j) / choose(A + B, i + j) * a[i] * b[j];
    return product;
}

/// Where a polynomial changes its sign within [0, 1], in order. What is not negative is taken for
/// positive, and the signs at 0 and 1 are those of the first and last coefficient themselves: of
/// two polynomials that share these to the bit at a joint, exactly one changes its sign there if
/// the two together do. Two changes within 1e-10 of each other may be left out.
template <std::size_t Degree>
class BernsteinRoots {
   public:
    explicit BernsteinRoots(const Bernstein<Degree>& f) { search(f, 0, 1); }

    const double* begin() const { return roots_.data(); }
    const double* end() const { return roots_.data() + count_; }

   private:
    /// By Descartes' rule there are at most as many roots as changes of sign in the coefficients,
    /// and one if that is one.
    void search(const Bernstein<Degree>& f, double low, double width) {
        std::size_t changes = 0;
        for (std::size_t k = 0; k < Degree; ++k) changes += (f[k] < 0) != (f[k + 1] < 0);
        if (changes == 0 || count_ == Degree) return;
        if (changes == 1) {
            roots_[count_++] = low + width * only_root(f);
            return;
        }
        if (width < 1e-10) return;
        // The halves have the first and last coefficients of the steps of corner cutting.
        Bernstein<Degree> left, right = f;
        for (std::size_t k = 0; k <= Degree; ++k) {
            left[k] = right[0];
            for (std::size_t i = 0; i + k < Degree; ++i) right[i] = .5 * (right[i] + right[i + 1]);
        }
        search(left, low, width / 2);
        search(right, low + width / 2, width / 2);
    }

    /// Newton's steps where they stay between the ends of different sign, else half way.
    static double only_root(const Bernstein<Degree>& f) {
        const bool rises = f[0] < 0;
        double low = 0, high = 1, t = f[0] / (f[0] - f[Degree]);
        for (int step = 0; step < 60 && high - low > 1e-15; ++step) {
            const auto [value, slope] = bernstein_value<Degree>(f, t);
            ((value < 0) == rises ? low : high) = t;
            const double next = t - value / slope;
            if (std::abs(next - t) < 1e-15) break;
            t = next > low && next < high ? next : (low + high) / 2;
        }
        return t;
    }

    std::array<double, Degree> roots_{};
    std::size_t count_ = 0;
};

}  // namespace povpreview
