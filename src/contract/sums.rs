//! How sums, differences and negatives are written of what is two parts, a real and a dual one:
//! part by part.

macro_rules! sums {
    ($(#[$of_sum:meta])* [$($number:tt)+] #[$inlined:meta] $Thing:ty: ($($real:tt)+) ($($dual:tt)+)) => {
        $(#[$of_sum])*
        impl<$($number)+> core::ops::Add for $Thing {
            type Output = Self;
            #[$inlined]
            fn add(self, other: Self) -> Self {
                Self::new(self.$($real)+ + other.$($real)+, self.$($dual)+ + other.$($dual)+)
            }
        }
        impl<$($number)+> core::ops::Sub for $Thing {
            type Output = Self;
            #[$inlined]
            fn sub(self, other: Self) -> Self {
                Self::new(self.$($real)+ - other.$($real)+, self.$($dual)+ - other.$($dual)+)
            }
        }
        impl<$($number)+> core::ops::Neg for $Thing {
            type Output = Self;
            #[$inlined]
            fn neg(self) -> Self {
                Self::new(-self.$($real)+, -self.$($dual)+)
            }
        }
    };
}
pub(crate) use sums;
