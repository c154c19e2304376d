"""The listings of the page on millions of poses, each from Parquet to Parquet, with every row once and right."""

import re
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from robots import ROBOTS, random_values

import dq8

PAGE = Path(__file__).parents[1] / "tutorial" / "millions.md"
LISTINGS = {part.split("\n")[0]: re.search(r"```python\n(.*?)```", part, re.DOTALL)[1] for part in PAGE.read_text().split("\n## ")[1:]}
MODULES = {
    "pyarrow": "pyarrow",
    "Polars": "polars",
    "DuckDB": "duckdb",
    "DataFusion": "datafusion",
    "Dask": "dask.dataframe",
    "Daft": "daft",
    "Ray": "ray.data",
}


def test_every_listing_is_run_and_short():
    assert set(LISTINGS) == set(MODULES)
    assert {name: len(text.splitlines()) for name, text in LISTINGS.items() if len(text.splitlines()) > 6} == {}


@pytest.mark.parametrize("name", MODULES)
def test_every_row_is_there_once_and_right(name, tmp_path, monkeypatch, request, rng):
    # What is not installed is not tried: requirements.txt has some, engines.txt the others.
    pytest.importorskip(MODULES[name])
    monkeypatch.chdir(tmp_path)
    arm = dq8.Mechanism.from_urdf(ROBOTS / "arm7.urdf")
    count = request.config.getoption("--rows")
    values = random_values(arm, rng, count)
    table = pa.table({"row": np.arange(count), "q": pa.array(dq8.to_arrow(values))})
    pq.write_table(table, "values.parquet", row_group_size=50_000)
    exec(LISTINGS[name], {"arm": arm, "dq8": dq8, "pa": pa, "pq": pq})
    made = pq.read_table("poses.parquet")
    rows = made["row"].to_numpy()
    assert len(rows) == count and np.array_equal(np.sort(rows), np.arange(count))
    np.testing.assert_array_equal(dq8.from_arrow(made["pose"]), arm.poses(values, "hand")[rows])
