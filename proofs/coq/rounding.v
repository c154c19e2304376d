(* Running error analysis: what one rounded operation does to bounds, and when a rounding is relative. *)
From Coq Require Import Reals Psatz.
From Flocq Require Import Core Relative.
Open Scope R_scope.

(* r is x rounded: off by u, relatively. *)
Definition near (u x r : R) := Rabs (r - x) <= u * Rabs x.

(* The normal range: rounding to nearest of IEEE 754 binary32 and binary64 is relative, of 0 and of all else that is normal.
   (Exponents have no upper end here: no overflow.) *)
Lemma near_f32 choice x : x = 0 \/ bpow radix2 (-126) <= Rabs x ->
  near (/ 16777216) x (round radix2 (FLT_exp (-149) 24) (Znearest choice) x).
Proof.
  intros [-> | normal]; unfold near.
  - rewrite round_0 by auto with typeclass_instances. rewrite Rminus_0_r, Rabs_R0. lra.
  - eapply Rle_trans. { apply (relative_error_N_FLT radix2 (-149) 24); [reflexivity | exact normal]. }
    apply Req_le. simpl. lra.
Qed.
Lemma near_f64 choice x : x = 0 \/ bpow radix2 (-1022) <= Rabs x ->
  near (/ 9007199254740992) x (round radix2 (FLT_exp (-1074) 53) (Znearest choice) x).
Proof.
  intros [-> | normal]; unfold near.
  - rewrite round_0 by auto with typeclass_instances. rewrite Rminus_0_r, Rabs_R0. lra.
  - eapply Rle_trans. { apply (relative_error_N_FLT radix2 (-1074) 53); [reflexivity | exact normal]. }
    apply Req_le. simpl. lra.
Qed.

Section Analysis.
Variable u : R.
Hypothesis least : 0 <= u.
Hypothesis most : u <= / 16777216.

(* n, computed, is m but for u·e, and m is no larger than a. *)
Definition bounded (n m a e : R) := Rabs m <= a /\ 0 <= e /\ Rabs (n - m) <= u * e.

Lemma constant c a : c = a \/ c = - a -> 0 <= a -> bounded c c a 0.
Proof.
  intros C A. unfold bounded. replace (c - c) with 0 by ring. rewrite Rabs_R0.
  assert (Rabs c = a) by (destruct C as [-> | ->]; rewrite ?Rabs_Ropp; apply Rabs_pos_eq; exact A). lra.
Qed.

(* A component of a vector of length l: its size is a number of its own, so that what follows stays short. *)
Lemma component l x : 0 <= l -> exists y, y = l * Rabs x /\ 0 <= y /\ bounded (l * x) (l * x) y 0.
Proof.
  intros. exists (l * Rabs x). unfold bounded. replace (l * x - l * x) with 0 by ring.
  rewrite Rabs_R0, Rabs_mult, (Rabs_pos_eq l) by lra. repeat split; try lra. apply Rmult_le_pos; [lra | apply Rabs_pos].
Qed.
(* And of one whose unit is its length. *)
Lemma given x : exists y, y = Rabs x /\ 0 <= y /\ bounded x x y 0.
Proof.
  exists (Rabs x). unfold bounded. replace (x - x) with 0 by ring. rewrite Rabs_R0. repeat split; try lra. apply Rabs_pos.
Qed.

Lemma opposite n m a e : bounded n m a e -> bounded (- n) (- m) a e.
Proof.
  intros (A & N & E). unfold bounded. rewrite Rabs_Ropp.
  replace (- n - - m) with (- (n - m)) by ring. rewrite Rabs_Ropp. lra.
Qed.

Lemma plus n m a e n' m' a' e' : bounded n m a e -> bounded n' m' a' e' -> bounded (n + n') (m + m') (a + a') (e + e').
Proof.
  intros (A & N & E) (A' & N' & E'). unfold bounded. repeat split; try lra.
  - eapply Rle_trans; [apply Rabs_triang | lra].
  - replace (n + n' - (m + m')) with ((n - m) + (n' - m')) by ring.
    eapply Rle_trans; [apply Rabs_triang | lra].
Qed.

Lemma minus n m a e n' m' a' e' : bounded n m a e -> bounded n' m' a' e' -> bounded (n - n') (m - m') (a + a') (e + e').
Proof. intros B B'. apply plus; [exact B | apply opposite; exact B']. Qed.

Lemma times n m a e n' m' a' e' : bounded n m a e -> bounded n' m' a' e' ->
  bounded (n * n') (m * m') (a * a') (a * e' + a' * e + / 16777216 * (e * e')).
Proof.
  intros (A & N & E) (A' & N' & E').
  pose proof (Rabs_pos m). pose proof (Rabs_pos m'). pose proof (Rabs_pos (n - m)). pose proof (Rabs_pos (n' - m')).
  assert (0 <= a * e') by (apply Rmult_le_pos; lra). assert (0 <= a' * e) by (apply Rmult_le_pos; lra).
  assert (0 <= e * e') by (apply Rmult_le_pos; lra).
  unfold bounded. repeat split; try lra.
  - rewrite Rabs_mult. apply Rmult_le_compat; lra.
  - replace (n * n' - m * m') with (m * (n' - m') + (m' * (n - m) + (n - m) * (n' - m'))) by ring.
    eapply Rle_trans; [apply Rabs_triang |].
    eapply Rle_trans; [apply Rplus_le_compat_l; apply Rabs_triang |].
    rewrite !Rabs_mult.
    assert (Rabs m * Rabs (n' - m') <= a * (u * e')) by (apply Rmult_le_compat; lra).
    assert (Rabs m' * Rabs (n - m) <= a' * (u * e)) by (apply Rmult_le_compat; lra).
    assert (Rabs (n - m) * Rabs (n' - m') <= (u * e) * (u * e')) by (apply Rmult_le_compat; lra).
    assert (u * (u * (e * e')) <= u * (/ 16777216 * (e * e'))).
    { apply Rmult_le_compat_l; [lra |]. apply Rmult_le_compat_r; lra. }
    lra.
Qed.

(* One rounding. *)
Lemma rounded n m a e r : bounded n m a e -> near u n r -> bounded r m a (e + a + / 16777216 * e).
Proof.
  intros (A & N & E) O. unfold near in O. unfold bounded. pose proof (Rabs_pos m).
  assert (Rabs n <= a + u * e).
  { replace n with (m + (n - m)) by ring. eapply Rle_trans; [apply Rabs_triang | lra]. }
  repeat split; try lra.
  replace (r - m) with ((r - n) + (n - m)) by ring.
  eapply Rle_trans; [apply Rabs_triang |].
  assert (u * Rabs n <= u * (a + u * e)) by (apply Rmult_le_compat_l; lra).
  assert (u * (u * e) <= u * (/ 16777216 * e)).
  { apply Rmult_le_compat_l; [lra |]. apply Rmult_le_compat_r; lra. }
  lra.
Qed.

(* An absolute value is off by no more than its operand. Gappa has no rule for it. *)
Lemma absolute n m e : Rabs (n - m) <= e -> Rabs (Rabs n - Rabs m) <= e.
Proof. intros H. apply Rle_trans with (2 := H). apply Rabs_triang_inv2. Qed.

Lemma below a c : - c <= a <= c -> Rabs a <= c.
Proof. intros. apply Rabs_le. assumption. Qed.

(* The root h of a computed sum of squares s that should be 1: as an exact number, and as one that is off from 1. *)
Lemma root s c : 0 <= c <= 8 -> Rabs (s - 1) <= u * c ->
  exists h, 0 < h /\ sqrt s = h /\ s = h * h /\ Rabs (h - 1) <= / 1000000
    /\ bounded h h (1 + / 1000000) 0 /\ bounded (/ h) (/ h) (1 + / 1000000) 0
    /\ bounded h 1 1 (c / 2 + / 100000) /\ bounded (/ h) 1 1 (c / 2 + / 100000).
Proof.
  intros [C0 C1] S.
  assert (W : 0 <= u * c <= / 2000000).
  { split; [apply Rmult_le_pos; lra |].
    apply Rle_trans with (/ 16777216 * 8); [apply Rmult_le_compat; lra | lra]. }
  set (w := u * c) in *. apply Rabs_le_inv in S.
  exists (sqrt s). set (h := sqrt s).
  assert (Q : h * h = s) by (apply sqrt_sqrt; lra).
  assert (P : 0 < h) by (apply sqrt_lt_R0; lra).
  (* 1 - w <= 1 - (w/2 + w²/2) is below the root, 1 + w/2 above. *)
  assert (A : h <= 1 + w / 2) by (apply Rsqr_incr_0_var; unfold Rsqr; nra).
  assert (B : 1 - (w / 2 + w * w) <= h) by (apply Rsqr_incr_0_var; unfold Rsqr; nra).
  assert (WW : w * w <= u * (/ 2000000 * 8)).
  { replace (w * w) with (u * (w * c)) by (unfold w; ring). apply Rmult_le_compat_l; [lra |]. apply Rmult_le_compat; lra. }
  assert (D : 0 <= w * w) by nra.
  assert (V : w / 2 = u * (c / 2)) by (unfold w; field).
  assert (K : / h * h = 1) by (apply Rinv_l; lra).
  assert (K0 : 0 < / h) by (apply Rinv_0_lt_compat; exact P).
  set (k := / h) in *. clearbody k.
  assert (K1 : k <= 1 + w / 2 + 2 * (w * w)) by nra.
  assert (K2 : 1 - w / 2 <= k) by nra.
  assert (KH : Rabs h = h) by (apply Rabs_pos_eq; lra).
  assert (KK : Rabs k = k) by (apply Rabs_pos_eq; lra).
  unfold bounded. replace (h - h) with 0 by ring. replace (k - k) with 0 by ring.
  rewrite !Rabs_R0, Rabs_R1, KH, KK.
  repeat split; try lra; try (apply below; nra).
Qed.

(* Divisions by the root, or what was computed of it, and by its square. *)
Lemma over n h a e : bounded n h a e -> Rabs (h - 1) <= / 1000000 -> 0 <= e <= 16 ->
  bounded (1 / n) (/ h) (1 + / 1000000 + / 1000000) (e * (1 + / 100000)).
Proof.
  intros (_ & _ & E) H [E0 E1]. apply Rabs_le_inv in H.
  assert (W : 0 <= u * e <= / 1000000).
  { split; [apply Rmult_le_pos; lra |].
    apply Rle_trans with (/ 16777216 * 16); [apply Rmult_le_compat; lra | lra]. }
  set (w := u * e) in *.
  assert (N : Rabs (n - h) <= w) by exact E. apply Rabs_le_inv in N.
  assert (K : / h * h = 1) by (apply Rinv_l; lra).
  assert (K' : / n * n = 1) by (apply Rinv_l; lra).
  assert (K0 : 0 < / h) by (apply Rinv_0_lt_compat; lra).
  assert (K0' : 0 < / n) by (apply Rinv_0_lt_compat; lra).
  unfold bounded. replace (1 / n - / h) with ((h - n) * (/ n * / h)) by (field; lra).
  set (k := / h) in *. set (k' := / n) in *. clearbody k k'.
  assert (k <= 1 + / 1000000 + / 1000000) by nra. assert (k' <= 1 + 3 * / 1000000) by nra.
  rewrite (Rabs_pos_eq k) by lra. repeat split; try lra; try nra.
  rewrite Rabs_mult, (Rabs_pos_eq (k' * k)) by (apply Rmult_le_pos; lra).
  assert (Rabs (h - n) <= w) by (apply below; lra).
  replace (u * (e * (1 + / 100000))) with (w * (1 + / 100000)) by (unfold w; ring).
  apply Rmult_le_compat; [apply Rabs_pos | apply Rmult_le_pos; lra | lra |].
  apply Rle_trans with ((1 + 3 * / 1000000) * (1 + / 1000000 + / 1000000)); [apply Rmult_le_compat; lra | lra].
Qed.

Lemma over_square h : 1 / (h * h) = / h * / h.
Proof. unfold Rdiv. rewrite Rinv_mult. ring. Qed.

Lemma weaker n m a e a' e' : bounded n m a e -> a <= a' -> e <= e' -> bounded n m a' e'.
Proof.
  intros (A & N & E) A' E'. unfold bounded. assert (u * e <= u * e') by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* Near t, of what is near m, which is near t. *)
Lemma joined n m a e m' t a' e' c :
  bounded n m a e -> m = m' -> bounded m' t a' e' -> e + e' <= c -> Rabs (n - t) <= u * c.
Proof.
  intros (_ & _ & E) -> (_ & _ & E') C. replace (n - t) with ((n - m') + (m' - t)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]. assert (u * (e + e') <= u * c) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* Roundings are relative: what holds in one unit holds in all. *)
Lemma scaled s x x' r : 0 < s -> near u x (s * r) -> x = s * x' -> near u x' r.
Proof.
  unfold near. intros S N ->. replace (s * r - s * x') with (s * (r - x')) in N by ring.
  rewrite !Rabs_mult, (Rabs_pos_eq s) in N by lra. apply (Rmult_le_reg_l s); lra.
Qed.
Lemma scaled_back s n t c : 0 < s -> Rabs (n - t) <= u * c -> Rabs (s * n - s * t) <= u * (c * s).
Proof.
  intros S E. replace (s * n - s * t) with (s * (n - t)) by ring. rewrite Rabs_mult, (Rabs_pos_eq s) by lra.
  replace (u * (c * s)) with (s * (u * c)) by ring. apply Rmult_le_compat_l; lra.
Qed.
Lemma scaled_root s x : 0 < s -> sqrt (s * s * x) = s * sqrt x.
Proof. intros S. rewrite sqrt_mult_alt, sqrt_square by nra. reflexivity. Qed.
Lemma scaled_over s x : 1 / (s * x) = / s * (1 / x).
Proof. unfold Rdiv. rewrite Rinv_mult. ring. Qed.

Lemma error n m a e c : bounded n m a e -> e <= c -> Rabs (n - m) <= u * c.
Proof. intros (_ & _ & E) C. eapply Rle_trans; [exact E |]. apply Rmult_le_compat_l; lra. Qed.
End Analysis.

(* Cauchy and Schwarz, term by term: with weights w, the sum over a matrix of x·y stays below its norm. *)
Lemma weighted w x y : 0 < w -> 2 * (x * y) <= w * (x * x) + / w * (y * y).
Proof.
  intros W. assert (0 <= / w * ((w * x - y) * (w * x - y))).
  { apply Rmult_le_pos; [apply Rlt_le, Rinv_0_lt_compat; exact W | apply Rle_0_sqr]. }
  replace (w * (x * x) + / w * (y * y)) with (2 * (x * y) + / w * ((w * x - y) * (w * x - y))) by (field; lra).
  lra.
Qed.

Lemma in_ball s t : 0 <= s <= 1 -> 0 <= t <= 1 -> 0 <= s * t <= 1.
Proof. intros S T. split; [apply Rmult_le_pos; lra |]. replace 1 with (1 * 1) by ring. apply Rmult_le_compat; lra. Qed.

Lemma square f x : 0 <= f -> 0 <= f * (x * x).
Proof. intros F. apply Rmult_le_pos; [exact F | apply Rle_0_sqr]. Qed.

Lemma same_square x : Rabs x * Rabs x = x * x.
Proof. rewrite <- Rabs_mult. apply Rabs_pos_eq, Rle_0_sqr. Qed.

(* Of units: products of lengths and of one over them. *)
Ltac nonzero := repeat split; try (apply Rgt_not_eq; assumption).
Ltac positive := repeat first [assumption | apply Rmult_lt_0_compat | apply Rinv_0_lt_compat | lra].
Ltac in_units :=
  match goal with
  | |- sqrt _ = _ => rewrite scaled_root by assumption; reflexivity
  | |- 1 / _ = _ => rewrite scaled_over, ?Rinv_mult; reflexivity
  | |- _ => field; nonzero
  end.
