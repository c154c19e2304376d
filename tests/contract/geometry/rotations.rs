//! Rotations in other forms.

use dq8::representation::EulerAngles;

geometry! { rotations:
    "EulerAngles::to_quat"(angles: point, order: order) -> quat, euler_to_quat, [
        on(&["near0"], 1.6, "small angles are halved, and multiplied by cosines of 1"),
        within(4.8, "three sines and cosines, and products of three")],
        alone Ok::<_, ()>(EulerAngles { angles, order }.to_quat());
    "Quat::to_euler"(a: unit_quat, order: order) -> euler, to_euler, [
        on(&["near lock"], 12.0, "as the others, and the sum of two angles up to π"),
        within(6.0, "arctangents, up to π, of which an ulp is 4 u")],
        alone Ok::<_, ()>(a.to_euler(order));
}
