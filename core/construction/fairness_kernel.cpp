#include "osculate/construction/fairness_kernel.h"

#include <cmath>
#include <cstring>

#include "osculate/differential/lanes.h"

// The loops are compiled twice: for processors with registers of four doubles, and for all.
#if defined(__x86_64__) && defined(__GNUC__)
#define OSCULATE_HAS_WIDE 1
#define OSCULATE_WIDE __attribute__((target("avx2")))
#endif
// into a function of either kind, which could not call one of the other
#define OSCULATE_INLINE inline __attribute__((always_inline))

namespace osculate {

namespace {

constexpr int kWidth = 4;  // of every sum, on every machine: the same digits

/// Four numbers that are added and multiplied at once (an extension that GCC and Clang share).
using Wide = double __attribute__((vector_size(32), aligned(8), may_alias));

/// The same by registers of two.
struct Narrow {
  Lanes low;
  Lanes high;

  Narrow& operator+=(const Narrow& other) {
    low += other.low;
    high += other.high;
    return *this;
  }
  double operator[](int lane) const { return lane < 2 ? low[lane] : high[lane - 2]; }
};

Narrow operator*(const Narrow& a, const Narrow& b) { return {a.low * b.low, a.high * b.high}; }
Narrow operator*(const Narrow& a, double b) { return {a.low * b, a.high * b}; }

/// By reference: wide registers cannot be returned where they might not exist.
template <class Four>
OSCULATE_INLINE void load(const double* numbers, Four& lanes) {
  std::memcpy(&lanes, numbers, sizeof(Four));
}

template <class Four>
OSCULATE_INLINE void store(const Four& lanes, double* numbers) {
  std::memcpy(numbers, &lanes, sizeof(Four));
}

/// out = basis * (row of the poles), for the three rows at once.
template <class Four, int Nodes>
OSCULATE_INLINE void multiply(const double* basis, const double* poles, int count,
                              NodeVectors<Nodes>& out) {
  for (int i = 0; i < Nodes; i += kWidth) {  // the sums stay in registers
    Four x{};
    Four y{};
    Four z{};
    for (int j = 0; j < count; ++j) {
      Four column;
      load(basis + j * Nodes + i, column);
      x += column * poles[3 * j];
      y += column * poles[3 * j + 1];
      z += column * poles[3 * j + 2];
    }
    store(x, out.at[0] + i);
    store(y, out.at[1] + i);
    store(z, out.at[2] + i);
  }
}

template <int Nodes>
OSCULATE_INLINE double dot(const NodeVectors<Nodes>& u, const NodeVectors<Nodes>& v, int i) {
  return u.at[0][i] * v.at[0][i] + u.at[1][i] * v.at[1][i] + u.at[2][i] * v.at[2][i];
}

template <class Four, int Nodes>
OSCULATE_INLINE void derivatives(const NodeTable<Nodes>& table, const double* poles, int count,
                                 NodeDerivatives<Nodes>& out) {
  multiply<Four>(table.basis[0].data(), poles, count, out.a);
  multiply<Four>(table.basis[1].data(), poles, count, out.b);
  multiply<Four>(table.basis[2].data(), poles, count, out.c);
  for (int i = 0; i < Nodes; ++i) {
    out.speed[i] = std::sqrt(dot(out.a, out.a, i));
    out.inverse[i] = 1.0 / out.speed[i];
    out.p[i] = dot(out.a, out.b, i);
  }
}

template <int Nodes>
OSCULATE_INLINE void variation(const NodeDerivatives<Nodes>& d, NodeDensity<Nodes>& out) {
  for (int i = 0; i < Nodes; ++i) {
    const double v = d.speed[i];
    const double i2 = d.inverse[i] * d.inverse[i];
    const double i3 = i2 * d.inverse[i];
    const double i5 = i3 * i2;
    const double i7 = i5 * i2;
    const double p = d.p[i];
    const double q = dot(d.b, d.b, i) + dot(d.a, d.c, i);
    const double byTangent = 4.0 * p * p * i7 - q * i5;
    const double byNormal = -3.0 * p * i5;
    double r[3];  // r_3, then 2 v r_3: the derivative of the density by r_3
    for (int x = 0; x < 3; ++x)
      r[x] = d.c.at[x][i] * i3 + byNormal * d.b.at[x][i] + byTangent * d.a.at[x][i];
    const double squared = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    out.f[i] = squared * v;
    double ga = 0.0;
    double gb = 0.0;
    double gc = 0.0;
    for (int x = 0; x < 3; ++x) {
      r[x] *= 2.0 * v;
      ga += r[x] * d.a.at[x][i];
      gb += r[x] * d.b.at[x][i];
      gc += r[x] * d.c.at[x][i];
    }
    const double byQ = -ga * i5;
    const double byP = 8.0 * p * ga * i7 - 3.0 * gb * i5;
    // by v, divided by v: |r_3|^2 / v and the powers of v in r_3
    const double byV = squared * d.inverse[i] + (-3.0 * gc * i5 + 15.0 * p * gb * i7 +
                                                 (5.0 * q * i7 - 28.0 * p * p * i7 * i2) * ga);
    for (int x = 0; x < 3; ++x) {
      out.byC.at[x][i] = r[x] * i3 + byQ * d.a.at[x][i];
      out.byB.at[x][i] = byNormal * r[x] + byP * d.a.at[x][i] + 2.0 * byQ * d.b.at[x][i];
      out.byA.at[x][i] =
          byTangent * r[x] + byP * d.b.at[x][i] + byQ * d.c.at[x][i] + byV * d.a.at[x][i];
    }
  }
}

template <int Nodes>
OSCULATE_INLINE void bending(const NodeDerivatives<Nodes>& d, NodeDensity<Nodes>& out) {
  for (int i = 0; i < Nodes; ++i) {
    const double i2 = d.inverse[i] * d.inverse[i];
    const double i3 = i2 * d.inverse[i];
    const double i5 = i3 * i2;
    const double p = d.p[i];
    const double bb = dot(d.b, d.b, i);
    out.f[i] = bb * i3 - p * p * i5;
    const double byV = 5.0 * p * p * i5 * i2 - 3.0 * bb * i5;
    for (int x = 0; x < 3; ++x) {
      out.byC.at[x][i] = 0.0;
      out.byB.at[x][i] = 2.0 * (d.b.at[x][i] * i3 - p * d.a.at[x][i] * i5);
      out.byA.at[x][i] = -2.0 * p * d.b.at[x][i] * i5 + byV * d.a.at[x][i];
    }
  }
}

/// Adds (row of the values) * basis for one column of the basis, at four nodes, to each sum.
template <class Four, int Nodes>
OSCULATE_INLINE void addProducts(const NodeVectors<Nodes>& values, const double* column, int i,
                                 Four (&sum)[3]) {
  Four factor;
  load(column + i, factor);
  for (int x = 0; x < 3; ++x) {
    Four value;
    load(values.at[x] + i, value);
    sum[x] += value * factor;
  }
}

/// The three rows of values times the columns of the bases, summed up.
template <class Four, int Nodes>
OSCULATE_INLINE void multiplyTransposed(const NodeTable<Nodes>& table, const NodeDensity<Nodes>& by,
                                        int count, double* gradient) {
  for (int j = 0; j < count; ++j) {
    Four sum[3] = {};
    for (int i = 0; i < Nodes; i += kWidth) {
      addProducts(by.byA, table.basis[0].data() + j * Nodes, i, sum);
      addProducts(by.byB, table.basis[1].data() + j * Nodes, i, sum);
      addProducts(by.byC, table.basis[2].data() + j * Nodes, i, sum);
    }
    for (int x = 0; x < 3; ++x)
      gradient[3 * j + x] = (sum[x][0] + sum[x][1]) + (sum[x][2] + sum[x][3]);
  }
}

template <class Four, int Nodes>
OSCULATE_INLINE void gradientOf(const NodeTable<Nodes>& table, const NodeDerivatives<Nodes>& d,
                                const NodeDensity<Nodes>& density,
                                const NodeFactors<Nodes>& factors, int count, double* gradient) {
  NodeDensity<Nodes> by;
  for (int x = 0; x < 3; ++x) {
    for (int i = 0; i < Nodes; ++i) {
      const double tangent = d.a.at[x][i] * d.inverse[i];
      by.byA.at[x][i] = factors.density[i] * density.byA.at[x][i] + factors.speed[i] * tangent;
      by.byB.at[x][i] = factors.density[i] * density.byB.at[x][i];
      by.byC.at[x][i] = factors.density[i] * density.byC.at[x][i];
    }
  }
  multiplyTransposed<Four>(table, by, count, gradient);
}

#ifdef OSCULATE_HAS_WIDE
const bool kIsWide = __builtin_cpu_supports("avx2") != 0;

template <int Nodes>
OSCULATE_WIDE void wideDerivatives(const NodeTable<Nodes>& table, const BoundedPoles& poles,
                                   NodeDerivatives<Nodes>& out) {
  derivatives<Wide>(table, poles.data(), static_cast<int>(poles.cols()), out);
}
template <int Nodes>
OSCULATE_WIDE void wideVariation(const NodeDerivatives<Nodes>& d, NodeDensity<Nodes>& out) {
  variation(d, out);
}
template <int Nodes>
OSCULATE_WIDE void wideGradient(const NodeTable<Nodes>& table, const NodeDerivatives<Nodes>& d,
                                const NodeDensity<Nodes>& density,
                                const NodeFactors<Nodes>& factors, BoundedPoles& gradient) {
  gradientOf<Wide>(table, d, density, factors, static_cast<int>(gradient.cols()), gradient.data());
}
#endif

}  // namespace

template <int Nodes>
void setDerivatives(const NodeTable<Nodes>& table, const BoundedPoles& poles,
                    NodeDerivatives<Nodes>& out) {
#ifdef OSCULATE_HAS_WIDE
  if (kIsWide) return wideDerivatives(table, poles, out);
#endif
  derivatives<Narrow>(table, poles.data(), static_cast<int>(poles.cols()), out);
}

template <int Nodes>
void setVariation(const NodeDerivatives<Nodes>& d, NodeDensity<Nodes>& out) {
#ifdef OSCULATE_HAS_WIDE
  if (kIsWide) return wideVariation(d, out);
#endif
  variation(d, out);
}

template <int Nodes>
void setBending(const NodeDerivatives<Nodes>& d, NodeDensity<Nodes>& out) {
  bending(d, out);
}

template <int Nodes>
void setGradient(const NodeTable<Nodes>& table, const NodeDerivatives<Nodes>& d,
                 const NodeDensity<Nodes>& density, const NodeFactors<Nodes>& factors,
                 BoundedPoles& gradient) {
#ifdef OSCULATE_HAS_WIDE
  if (kIsWide) return wideGradient(table, d, density, factors, gradient);
#endif
  gradientOf<Narrow>(table, d, density, factors, static_cast<int>(gradient.cols()),
                     gradient.data());
}

template void setDerivatives(const NodeTable<kCoarseNodes>&, const BoundedPoles&,
                             NodeDerivatives<kCoarseNodes>&);
template void setVariation(const NodeDerivatives<kCoarseNodes>&, NodeDensity<kCoarseNodes>&);
template void setBending(const NodeDerivatives<kCoarseNodes>&, NodeDensity<kCoarseNodes>&);
template void setGradient(const NodeTable<kCoarseNodes>&, const NodeDerivatives<kCoarseNodes>&,
                          const NodeDensity<kCoarseNodes>&, const NodeFactors<kCoarseNodes>&,
                          BoundedPoles&);
template void setDerivatives(const NodeTable<kFineNodes>&, const BoundedPoles&,
                             NodeDerivatives<kFineNodes>&);
template void setVariation(const NodeDerivatives<kFineNodes>&, NodeDensity<kFineNodes>&);
template void setBending(const NodeDerivatives<kFineNodes>&, NodeDensity<kFineNodes>&);
template void setGradient(const NodeTable<kFineNodes>&, const NodeDerivatives<kFineNodes>&,
                          const NodeDensity<kFineNodes>&, const NodeFactors<kFineNodes>&,
                          BoundedPoles&);

}  // namespace osculate
