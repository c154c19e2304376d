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

(* A component of a vector of length l. *)
Lemma component l x : 0 <= l -> bounded (l * x) (l * x) (l * Rabs x) 0.
Proof.
  intros. unfold bounded. replace (l * x - l * x) with 0 by ring.
  rewrite Rabs_R0, Rabs_mult, (Rabs_pos_eq l) by lra. lra.
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
