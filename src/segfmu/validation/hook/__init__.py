"""The crane with a hook in files, views and refusals."""
