(* How far errors grow along a chain of joints, from the bounds of one step.

   e and f are the lengths of the errors of p and q after n joints, of unit rotations and bones of length b. A step rounds
   each component of a product by 4.001 u |p||r| and u (5.001 |p||s| + 5.001 |q||r|) at most (local_to_model), or, in
   blocks, u (8.001 |p||s| + 5.001 |q||r|) (local_to_model_blocks); the length of four such is twice that: d is 10.002 or
   16.002. Exactly, |p| = |r| = 1, |s| = b/2 and |q| <= n b/2. tests/forms.rs compares these numbers with bounds.toml. *)
From Coq Require Import Reals Psatz.
Open Scope R_scope.

Section Chain.
Variables (u b d : R) (e f : nat -> R).
Hypothesis D : 10.002 <= d <= 16.002.
Hypothesis U : 0 <= u.
Hypothesis B : 0 <= b.
Hypothesis E : forall n, 0 <= e n.
Hypothesis F : forall n, 0 <= f n.
Hypothesis E0 : e 0%nat = 0.
Hypothesis F0 : f 0%nat = 0.
Hypothesis ES : forall n, e (S n) <= e n + 8.002 * u * (1 + e n).
Hypothesis FS : forall n,
  f (S n) <= f n + b / 2 * e n + u * (d * ((1 + e n) * (b / 2)) + 10.002 * (INR n * (b / 2) + f n)).

Lemma rotation n : INR n * u <= / 1000 -> e n <= 8.1 * (INR n * u).
Proof.
  induction n as [| n grown]; intros few.
  - rewrite E0. simpl. lra.
  - rewrite S_INR in *. specialize (grown ltac:(lra)).
    assert (u * e n <= u * 0.0081) by (apply Rmult_le_compat_l; lra). pose proof (ES n). lra.
Qed.

Lemma dual n : INR n * u <= / 1000 ->
  f n <= b / 2 * u * (9.2 * (INR n * INR n) + (d - 8.902) * INR n).
Proof.
  induction n as [| n grown]; intros few.
  - rewrite F0. simpl. lra.
  - rewrite S_INR in *. specialize (grown ltac:(lra)). pose proof (rotation n ltac:(lra)) as turned.
    pose proof (FS n) as step. pose proof (pos_INR n) as positive.
    set (x := INR n) in *. set (k := b / 2 * u) in *.
    assert (K : 0 <= k) by (apply Rmult_le_pos; lra).
    assert (b / 2 * e n <= k * (8.1 * x)).
    { replace (k * (8.1 * x)) with (b / 2 * (8.1 * (x * u))) by (unfold k; ring). apply Rmult_le_compat_l; lra. }
    assert (u * (d * ((1 + e n) * (b / 2))) <= k * (d * 1.0081)).
    { replace (u * (d * ((1 + e n) * (b / 2)))) with (k * (d * (1 + e n))) by (unfold k; ring).
      apply Rmult_le_compat_l; [exact K |]. apply Rmult_le_compat_l; lra. }
    assert (k * d <= k * 16.002) by (apply Rmult_le_compat_l; lra).
    assert (k * 10.002 <= k * d) by (apply Rmult_le_compat_l; lra).
    assert (u * (x * (b / 2)) = k * x) by (unfold k; ring).
    assert (u * f n <= k * (0.001 * (9.2 * x + (d - 8.902)))).
    { eapply Rle_trans; [apply Rmult_le_compat_l; [exact U | exact grown] |].
      replace (u * (k * (9.2 * (x * x) + (d - 8.902) * x))) with (k * ((x * u) * (9.2 * x + (d - 8.902)))) by ring.
      apply Rmult_le_compat_l; [exact K |]. apply Rmult_le_compat_r; lra. }
    assert (0 <= k * x) by (apply Rmult_le_pos; lra).
    lra.
Qed.

(* Each coordinate of t = 2 q p*: off by the errors of p and q, and by its own rounding, 8.001 u |p||q| on lanes and less on single motions. *)
Theorem translation n (t : R) :
  INR n * u <= / 1000 ->
  t <= 2 * (f n * (1 + e n) + INR n * (b / 2) * e n) + 8.001 * u * ((1 + e n) * (INR n * (b / 2) + f n)) ->
  t <= u * (INR n * b) * (17.5 * INR n + (d - 4.002)).
Proof.
  intros few off. pose proof (rotation n few) as turned. pose proof (dual n few) as moved. pose proof (pos_INR n) as positive.
  specialize (E n). specialize (F n).
  set (x := INR n) in *. set (k := b / 2 * u) in *. set (m := k * (9.2 * (x * x) + (d - 8.902) * x)) in *.
  assert (K : 0 <= k) by (apply Rmult_le_pos; lra).
  assert (0 <= k * x) by (apply Rmult_le_pos; lra).
  assert (0 <= k * x * x) by (apply Rmult_le_pos; lra).
  assert (f n * (1 + e n) <= m * 1.0081) by (apply Rmult_le_compat; lra).
  assert (x * (b / 2) * e n <= k * (8.1 * (x * x))).
  { replace (k * (8.1 * (x * x))) with (x * (b / 2) * (8.1 * (x * u))) by (unfold k; ring).
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | lra]. }
  assert (u * m <= 0.001 * (k * (9.2 * x + (d - 8.902)))).
  { unfold m. replace (u * (k * (9.2 * (x * x) + (d - 8.902) * x))) with ((x * u) * (k * (9.2 * x + (d - 8.902)))) by ring.
    apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | lra]. }
  assert (0 <= x * (b / 2)) by (apply Rmult_le_pos; lra).
  assert (u * ((1 + e n) * (x * (b / 2) + f n)) <= 1.0081 * (k * x + u * m)).
  { replace (k * x + u * m) with (u * (x * (b / 2) + m)) by (unfold k; ring).
    replace (1.0081 * (u * (x * (b / 2) + m))) with (u * (1.0081 * (x * (b / 2) + m))) by ring.
    apply Rmult_le_compat_l; [exact U |]. apply Rmult_le_compat; lra. }
  replace (u * (x * b) * (17.5 * x + (d - 4.002))) with (k * (2 * x) * (17.5 * x + (d - 4.002))) by (unfold k; field).
  (* Of no joint there is nothing; of one and more, x <= x². *)
  destruct n as [| n'].
  - assert (x = 0) as none by reflexivity. unfold m in *. rewrite none in *. lra.
  - assert (1 <= x) by (unfold x; rewrite S_INR; pose proof (pos_INR n'); lra).
    assert (k * x <= k * x * x) by (rewrite <- (Rmult_1_r (k * x)) at 1; apply Rmult_le_compat_l; lra).
    assert (k <= k * x) by (rewrite <- (Rmult_1_r k) at 1; apply Rmult_le_compat_l; lra).
    assert (k * x * d <= k * x * 16.002) by (apply Rmult_le_compat_l; lra).
    assert (k * d <= k * 16.002) by (apply Rmult_le_compat_l; lra).
    assert (k * 10.002 <= k * d) by (apply Rmult_le_compat_l; lra).
    unfold m in *. lra.
Qed.
End Chain.
Print Assumptions translation.
