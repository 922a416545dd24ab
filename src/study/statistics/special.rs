//! The distribution functions behind the tests, on `libm` alone.

/// The regularised incomplete beta function `I_x(a, b)`.
///
/// - `a`, `b`: above 0.
/// - `x`: in `[0, 1]`.
///
/// Source: the continued fraction of DLMF 8.17.22, evaluated by Lentz's method.
#[must_use]
pub fn beta_inc(a: f64, b: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return 1.0;
    }
    // The fraction converges fast only on the near side of the distribution's mean.
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - beta_inc_near(b, a, 1.0 - x);
    }
    beta_inc_near(a, b, x)
}

fn beta_inc_near(a: f64, b: f64, x: f64) -> f64 {
    let ln_front = libm::lgamma(a + b) - libm::lgamma(a) - libm::lgamma(b) + a * libm::log(x) + b * libm::log1p(-x);
    libm::exp(ln_front) / (a * fraction(a, b, x))
}

/// The value of 1 + d1/(1 + d2/(1 + ...)).
fn fraction(a: f64, b: f64, x: f64) -> f64 {
    const TINY: f64 = 1e-300;
    let guard = |value: f64| if value.abs() < TINY { TINY } else { value };
    let (mut value, mut over, mut under) = (1.0, 1.0, 0.0);
    for step in 1..=10_000_u32 {
        let half = f64::from(step / 2);
        let term = if step % 2 == 0 {
            half * (b - half) * x / ((a + 2.0 * half - 1.0) * (a + 2.0 * half))
        } else {
            -(a + half) * (a + b + half) * x / ((a + 2.0 * half) * (a + 2.0 * half + 1.0))
        };
        under = 1.0 / guard(1.0 + term * under);
        over = guard(1.0 + term / over);
        value *= over * under;
        if (over * under - 1.0).abs() < 1e-15 {
            break;
        }
    }
    value
}

/// The probability that a standard normal draw is above `z`.
#[must_use]
pub fn normal_upper(z: f64) -> f64 {
    0.5 * libm::erfc(z / std::f64::consts::SQRT_2)
}
